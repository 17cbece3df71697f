// Clouds without thickness: fBm on a plane high up, for skies that have little time.

#include <fractal/fbm.wgsl> as planar_clouds with noise2 = perlin_noise2_grad
#include <frame.wgsl>
#include <light/daylight.wgsl>
#include <light/phase.wgsl>
#include <math/rotation.wgsl>
#include <noise/perlin.wgsl>

/// Height of the plane above sea level.
#param veil.height: f32 = 6000.0, range -5000 .. 100000, unit m
/// How much of the sky has clouds.
#param veil.coverage: f32 = 0.5, range 0 .. 1
/// Optical depth, straight through, of the thickest places.
#param veil.depth: f32 = 2.5, range 0 .. 50
/// Width of the largest patches.
#param veil.scale: f32 = 5000.0, range 10 .. 200000, log, unit m
/// How much longer patches are along the wind than across.
#param veil.combed: f32 = 1.6, range 1 .. 10
/// How gently patches begin: small is a crisp edge.
#param veil.softness: f32 = 0.7, range 0.01 .. 2
/// Where the wind blows to, clockwise from north.
#param veil.wind_heading: f32 = 70.0, range -360 .. 360, unit deg
/// How fast it blows.
#param veil.wind_speed: f32 = 15.0, range 0 .. 200, unit m/s
/// Which clouds: another seed, another sky.
#param veil.seed: u32 = 1

const PLANAR_CLOUDS_OCTAVES: f32 = 7.0;
const PLANAR_CLOUDS_GAIN: f32 = 0.52;
const PLANAR_CLOUDS_SPREAD: f32 = 0.36; // standard deviation of the sum of octaves
// Toward the horizon rays run along the plane: patches blend into haze from this sine of the elevation down.
const PLANAR_CLOUDS_GRAZING: f32 = 0.06;

/// What a ray sees of the clouds on the plane.
struct PlanarCloudsSeen {
    /// Radiance that they send to the ray's origin, without the air between.
    radiance: vec3f,
    /// Part of what is behind that shows, 0 .. 1.
    transmittance: f32,
    /// Distance of the plane (m).
    distance: f32,
}

/// Optical depth straight through the plane at `place` (m east, m south), 0 .. `veil.depth`; details smaller than
/// `footprint` (m) are left out.
fn planar_clouds_depth(place: vec2f, footprint: f32) -> f32 {
    let heading = vec2f(sin(veil.wind_heading), -cos(veil.wind_heading));
    let carried = place - veil.wind_speed * frame.time * heading;
    let along = vec2f(dot(carried, heading) / veil.combed, dot(carried, vec2f(-heading.y, heading.x)));
    let octaves = clamp(log2(veil.scale / max(footprint, 1e-3)) - 1.0, 1.0, PLANAR_CLOUDS_OCTAVES);
    let noise = planar_clouds_fbm2(along / veil.scale, veil.seed, octaves, PLANAR_CLOUDS_GAIN, 2.07).x;
    // Exceeded by `coverage` of a normal distribution, near enough.
    let score = 0.5513 * log((1.0 - veil.coverage + 1e-5) / (veil.coverage + 1e-5));
    let over = clamp((noise - PLANAR_CLOUDS_SPREAD * score) / veil.softness, 0.0, 1.0);
    return veil.depth * over * over * (3.0 - 2.0 * over);
}

/// The clouds on the plane between `near` and `far` (m) along the unit `direction`, in the light of `day`.
///
/// A slab of the depth that is found where the ray crosses the plane: its first order of scattering, the rest as a
/// slab of that thickness passes on or throws back. From above and below; nothing where the ray does not cross. One
/// fBm.
fn planar_clouds_trace(
    origin: vec3f,
    direction: vec3f,
    near: f32,
    far: f32,
    pixel_angle: f32,
    day: Daylight,
) -> PlanarCloudsSeen {
    let climb = veil.height - origin.y;
    let steepness = abs(direction.y);
    let way = climb / max(steepness, 1e-4) * select(-1.0, 1.0, direction.y > 0.0);
    if !(way > max(near, 0.0)) || way >= far || steepness < 1e-4 {
        return PlanarCloudsSeen(vec3f(0.0), 1.0, far);
    }
    let footprint = way * pixel_angle / max(sqrt(steepness), 0.05);
    let depth = planar_clouds_depth(origin.xz + way * direction.xz, footprint);
    let slant = depth / max(steepness, PLANAR_CLOUDS_GRAZING) * smoothstep(0.0, PLANAR_CLOUDS_GRAZING, steepness);
    let covered = 1.0 - exp(-min(slant, 80.0));
    let sun_height = max(abs(day.to_sun.y), 0.05);
    let cos_theta = dot(direction, day.to_sun);
    // First order: sunlight is dimmed by half of the slab on the way to the middle of what is seen.
    let first = phase_two_lobe(cos_theta, 0.8, -0.3, 0.85) * exp(-0.5 * min(depth / sun_height, 80.0));
    // The rest, diffuse (Eddington): what goes through the slab, or comes back.
    let reflected = 0.15 * 0.75 * depth / (1.0 + 0.15 * 0.75 * depth);
    let lit_side = direction.y * day.to_sun.y < 0.0; // the eye is on the sun's side
    let scattered = 1.0 - exp(-min(depth / sun_height, 80.0));
    let diffuse = select(1.0 - reflected, reflected, lit_side) * scattered * sun_height * 0.31830989;
    let ambient = 0.31830989 * select(1.0 - reflected, 1.0, lit_side);
    let is_day = smoothstep(-0.1, 0.02, day.to_sun.y);
    let radiance = covered * ((first + diffuse) * is_day * day.sun + ambient * day.sky);
    return PlanarCloudsSeen(radiance, 1.0 - covered, way);
}

/// Part of the sun, 0 .. 1, that the clouds on the plane leave to `position` (m).
fn planar_clouds_shadow(position: vec3f, to_sun: vec3f) -> f32 {
    let climb = veil.height - position.y;
    if climb <= 0.0 || to_sun.y <= 0.01 {
        return 1.0;
    }
    let place = position.xz + climb / to_sun.y * to_sun.xz;
    return exp(-min(planar_clouds_depth(place, 0.02 * climb) / to_sun.y, 80.0));
}
