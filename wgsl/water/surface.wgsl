// The water's surface: where a ray meets it, how rough it is there, and what it mirrors.

#include <camera/camera.wgsl>
#include <frame.wgsl>
#include <light/daylight.wgsl>
#include <light/facets.wgsl>
#include <light/fresnel.wgsl>
#include <water/level.wgsl>
#include <water/optics.wgsl>
#include <water/wind.wgsl>

/// How the surface is moved: not at all, by noise (lakes), or by Gerstner's waves, which have crests and height (the sea).
#option water.waves = noise { none, noise, gerstner }

#if water.waves == noise
#include <water/ripples.wgsl>
#elif water.waves == gerstner
#include <water/gerstner.wgsl>
#include <water/ripples.wgsl>
#endif

/// The surface where a ray meets it.
struct WaterHit {
    /// Whether it meets it at all.
    hit: bool,
    /// How far away (m).
    distance: f32,
}

/// Light that leaves the surface toward the eye.
struct WaterMirror {
    /// Unit direction that is mirrored, never below the horizon.
    direction: vec3f,
    /// Part of the light from there that is reflected, 0 .. 1; the rest goes into the water.
    reflectance: f32,
    /// Radiance of the sun's image, for the whole sun; none of it is in `direction`.
    glint: vec3f,
    /// How far up and down from `direction` waves too small to see scatter what is mirrored (rad, standard deviation).
    blur: f32,
}

/// The waves at `p` (m) as seen by a pixel `footprint` (m) wide.
fn water_surface_waves(p: vec2f, footprint: f32) -> Waves {
#if water.waves == noise
    return ripples(p, footprint, water.wave_length, water.slope * water_breeze(p, footprint));
#elif water.waves == gerstner
    // What is shorter than the shortest of them holds the other half of the slope.
    var seen = gerstner_waves(p, footprint);
    let roughness = 0.70711 * water.slope * water_breeze(p, footprint);
    let fine = ripples(p, footprint, water.wave_length / 32.0, roughness);
    seen.slope += fine.slope;
    seen.variance += fine.variance;
    return seen;
#else
    return Waves(0.0, vec2f(0.0), 0.0, 0.0);
#endif
}

/// Width (m) along the line of sight of what a pixel covers of the surface `distance` (m) away, seen in `direction`.
fn water_footprint(distance: f32, direction: vec3f) -> f32 {
    return distance * camera_pixel_angle() / max(abs(direction.y), 0.003);
}

/// Where a ray from above meets the surface, or one from below; not looked for beyond `far` (m).
fn water_trace(origin: vec3f, direction: vec3f, far: f32) -> WaterHit {
    let climb = water.level - origin.y;
    if abs(direction.y) < 1e-6 || climb * direction.y < 0.0 {
        return WaterHit(false, far);
    }
    let level = climb / direction.y;
    if level > far {
        return WaterHit(false, far);
    }
#if water.waves == gerstner
    // Down through the layer that the crests are in: even steps to the first that is below the surface, then halvings.
    let reach = gerstner_reach();
    let footprint = water_footprint(level, direction);
    if climb < 0.0 && water.wave_length > 2.0 * footprint {
        let wide = reach / max(-direction.y, 0.02);
        var before = max(level - wide, 0.0);
        let pace = (level + wide - before) / 24.0;
        var after = level + wide;
        var step_length = pace;
        var t = before;
        for (var i = 0; i < 32; i++) {
            t = before + step_length;
            let p = origin + t * direction;
            if p.y - water.level > gerstner_at(p.xz, footprint).offset.y {
                before = t;
            } else {
                after = t;
                step_length *= 0.5;
            }
            if t >= level + wide {
                break;
            }
            step_length = min(step_length, after - before);
        }
        return WaterHit(true, min(after, far));
    }
#endif
    return WaterHit(true, level);
}

/// What the surface with `waves` mirrors when it is looked at from above in the unit `direction`; `sun_seen` is the part of
/// the sun of `day` that shines on it.
///
/// Waves that are too small to see tilt the mirror toward the eye, as far as those that are seen do on the average, and
/// make the sun's image a glitter path. The one facet's reflectance is that of all within .02 for slopes of .05, .08 for
/// .2; a smooth surface's would be off by .23 and .6. A renderer that accumulates frames draws a facet at random
/// for every one, by `frame.jitter`: what is mirrored is then blurred as it should be.
fn water_mirror(direction: vec3f, waves: Waves, day: Daylight, sun_seen: f32) -> WaterMirror {
    let to_eye = vec3f(-direction.x, max(-direction.y, 1e-4), -direction.z);
    let level = max(length(to_eye.xz), 1e-4);
    let toward = select(vec2f(1.0, 0.0), to_eye.xz / level, level > 1e-4);
    let beside = vec2f(-toward.y, toward.x);
    let tan_view = to_eye.y / level;
    // Slopes toward the eye and across.
    let lean = vec2f(-dot(waves.slope, toward), -dot(waves.slope, beside));
    let deviation = sqrt(max(waves.variance, 1e-7));
    let seen = facets_seen_slope(tan_view + lean.x, deviation);
    let drawn = clamp(frame.jitter + 0.5, vec2f(0.02), vec2f(0.98));
    let normal_draw = log(drawn / (1.0 - drawn)) / 1.702; // near enough normally distributed; 0 for no jitter
    // Facets that lean farther away than `steepest` would mirror what is below the horizon; before they do, other waves
    // hide them.
    let steepest = to_eye.y / (1.0 + level);
    let along = max(lean.x + seen.x + seen.y * normal_draw.y, -0.7 * steepest);
    let across = lean.y + deviation * normal_draw.x;
    let tilt = along * toward + across * beside;
    let normal = normalize(vec3f(tilt.x, 1.0, tilt.y));
    let cos_theta = clamp(dot(normal, to_eye), 0.0, 1.0);
    var mirrored = 2.0 * cos_theta * normal - to_eye;
    mirrored.y = max(mirrored.y, 0.002);

    let to_sun = day.to_sun;
    var glint = vec3f(0.0);
    if to_sun.y > 0.0 {
        let half_way = normalize(to_sun + to_eye);
        let slope = vec2f(dot(half_way.xz, toward), dot(half_way.xz, beside)) / half_way.y;
        let blur = sqrt(deviation * deviation + day.radius * day.radius / 16.0); // the sun's own width
        let area = level * facets_seen_area(tan_view + lean.x, deviation);
        let strength = facets_glint(slope - lean, half_way.y, blur, max(area, 1e-4));
        let reflected = fresnel_dielectric(clamp(dot(half_way, to_eye), 0.0, 1.0), WATER_IOR);
        glint = min(sun_seen * reflected * strength * day.sun, vec3f(200.0));
    }
    return WaterMirror(normalize(mirrored), fresnel_dielectric(cos_theta, WATER_IOR), glint, 2.0 * seen.y);
}
