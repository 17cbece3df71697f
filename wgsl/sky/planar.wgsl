// The air of an infinite flat world: no horizon curves away.

#include <geometry/ray.wgsl>
#include <light/phase.wgsl>
#include <sky/air.wgsl>
#include <sky/medium.wgsl>
#include <sky/nodes.wgsl>
#include <sun/key.wgsl>

/// Height at which the flat world's air ends.
#param planar.air_height: f32 = 80000.0, range 100 .. 10000000, log, unit m
/// How much of the light that was scattered before, or thrown back by the ground, is counted.
#param planar.diffuse: f32 = 1.0, range 0 .. 4

// As far below height 0 (m) things may lie and still be seen through air.
const PLANAR_BELOW: f32 = 1000.0;

/// Densities of molecules and aerosols at height `y` (m): e^(−y / scale) (top − y) / top, which is 0 at the top.
fn planar_density(y: f32) -> vec2f {
    let inside = clamp(y, -PLANAR_BELOW, planar.air_height);
    let scale = vec2f(sky.rayleigh_height, sky.mie_height);
    return exp(clamp(-inside / scale, vec2f(-87.0), vec2f(40.0))) * (1.0 - inside / planar.air_height);
}

/// Optical paths (m) straight up from height `y`: the density's integral.
fn planar_column(y: f32) -> vec2f {
    let inside = clamp(y, -PLANAR_BELOW, planar.air_height);
    let scale = vec2f(sky.rayleigh_height, sky.mie_height);
    let flat_part = scale / planar.air_height;
    let here = exp(clamp(-inside / scale, vec2f(-87.0), vec2f(40.0)));
    let top = exp(max(-1.0 / flat_part, vec2f(-87.0)));
    return max(scale * (flat_part * top + here * (1.0 - inside / planar.air_height - flat_part)), vec2f(0.0));
}

/// Optical depth of `distance` (m) from height `y` on, `climb` (m) higher for each metre. In closed form.
fn planar_depth(y: f32, climb: f32, distance: f32) -> vec3f {
    let rise = climb * distance;
    var path = planar_density(y + 0.5 * rise) * distance;
    if abs(rise) > 0.01 * min(sky.rayleigh_height, sky.mie_height) {
        path = abs(planar_column(y) - planar_column(y + rise)) / abs(climb);
    }
    return medium_extinction(vec3f(path, 0.0));
}

/// The cosine that stands for `light_mu` in slant paths, > 0. A flat world's night would fall with the sun's centre;
/// this one dims as if its ground were curved.
fn planar_slant(light_mu: f32) -> f32 {
    let curved = 2.546 * sky.rayleigh_height / sky.ground_radius; // Chapman's at the horizon
    return max(0.5 * (light_mu + sqrt(light_mu * light_mu + curved)), 1e-3);
}

/// Part of the light from `light_mu`, the cosine of its zenith angle, that reaches height `y`. Ozone takes its part here
/// and nowhere else: over the low sun's long way it keeps the zenith blue.
fn planar_transmittance(y: f32, light_mu: f32) -> vec3f {
    let above = clamp(0.5 + 0.5 * (sky.ozone_center - y) / sky.ozone_half_width, 0.0, 1.0);
    let path = vec3f(planar_column(y), sky.ozone_half_width * above);
    return exp(-medium_extinction(path / planar_slant(light_mu)));
}

/// Irradiance of level ground by the sky, for a light of irradiance 1: two streams through air that hides nothing
/// (Eddington), the direct light taken off, and what ground and air throw back and forth.
fn planar_from_sky(light_mu: f32) -> vec3f {
    let mu = planar_slant(light_mu);
    let column = planar_column(0.0);
    let mie = (1.0 - max(sky.mie_asymmetry, 0.0)) * sky.mie_scattering;
    let depth = 1e-6 * (column.x * sky.rayleigh_scattering + column.y * mie);
    let direct = exp(-depth / mu);
    let through = (2.0 / 3.0 + mu + (2.0 / 3.0 - mu) * direct) / (4.0 / 3.0 + depth);
    let back = depth / (4.0 / 3.0 + depth); // of light from below
    let all = through / (1.0 - sky.ground_albedo * back);
    let ozone = exp(-1e-6 * sky.ozone_half_width * sky.ozone_absorption / mu);
    let absorbed = exp(-1e-6 * column.y * sky.mie_absorption / mu);
    return planar.diffuse * mu * absorbed * ozone * max(all - direct, vec3f(0.0));
}

/// The air from `origin` (m) to `distance` (m) along the unit `direction`; from `RAY_FAR` on all of it, and the sunlit
/// plane at height 0 where the ray ends on that.
fn planar_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
    let endless = distance >= RAY_FAR;
    let low = select(-PLANAR_BELOW, 0.0, endless);
    let climb = direction.y;
    let eye = max(origin.y, low);
    if eye >= planar.air_height && climb >= 0.0 {
        return SkyAir(vec3f(0.0), vec3f(0.0), vec3f(1.0));
    }
    let entry = max(eye - planar.air_height, 0.0) / max(-climb, 1e-9);
    let start = min(eye, planar.air_height);
    let bound = select(planar.air_height - start, start - low, climb < 0.0) / max(abs(climb), 1e-9);
    // Level rays end where next to nothing is seen any more.
    let extinction = medium_extinction(vec3f(planar_density(start), 0.0));
    let thinnest = max(min(extinction.x, min(extinction.y, extinction.z)), 1e-12);
    let way = clamp(min(distance - entry, bound), 0.0, 12.0 / thinnest + 8.0 * planar.air_height);

    let to_sun = key_direction();
    let cos_theta = dot(direction, to_sun);
    let rayleigh = 1e-6 * sky.rayleigh_scattering;
    let mie = 1e-6 * sky.mie_scattering;
    let first_rayleigh = rayleigh * phase_rayleigh(cos_theta);
    let first_mie = mie * phase_cornette_shanks(cos_theta, sky.mie_asymmetry);
    let down = planar_from_sky(to_sun.y);
    let direct = max(to_sun.y, 0.0) * planar_transmittance(0.0, to_sun.y);
    let ground = sky.ground_albedo * (direct + down) / 3.14159265; // its radiance
    let mean = 0.5 * (down / 3.14159265 + planar.diffuse * ground); // radiance of all other light, from all around

    let from_end = smoothstep(1.0, 4.0, -climb * way / sky.rayleigh_height);
    var from_sun = vec3f(0.0);
    var from_sky = vec3f(0.0);
    for (var i = 0; i < SKY_NODES; i++) {
        let node = sky_node(i, SKY_NODES, from_end);
        let y = start + climb * way * node.x;
        let density = planar_density(y);
        let seen = way * node.y * exp(-planar_depth(start, climb, way * node.x));
        from_sun += seen * planar_transmittance(y, to_sun.y) * (density.x * first_rayleigh + density.y * first_mie);
        from_sky += seen * mean * (density.x * rayleigh + density.y * mie);
    }
    var left = exp(-planar_depth(start, climb, way));
    if endless && climb < 0.0 {
        from_sky += left * ground;
        left = vec3f(0.0);
    }
    return SkyAir(key_light() * from_sun, key_light() * from_sky, left);
}

/// Irradiance of a surface that faces the light that throws the shadows, after the air.
fn planar_sunlight(position: vec3f) -> vec3f {
    let to_light = key_direction();
    let risen = smoothstep(-key_radius(), key_radius(), asin(clamp(to_light.y, -1.0, 1.0)));
    return risen * key_light() * planar_transmittance(position.y, to_light.y);
}

/// Irradiance of level ground by the whole sky.
fn planar_irradiance(position: vec3f) -> vec3f {
    let through = planar_column(position.y).x / planar_column(0.0).x; // less air, less of its light
    return key_light() * planar_from_sky(key_direction().y) * min(through, 1.0);
}
