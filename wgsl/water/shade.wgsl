// Water seen by a ray: what it hides, what it mirrors, and how much of what lies behind is left.

#include <light/daylight.wgsl>
#include <light/fresnel.wgsl>
#include <water/foam.wgsl>
#include <water/level.wgsl>
#include <water/optics.wgsl>
#include <water/surface.wgsl>

/// Water in front of something else: what is seen is `own` + `passed` · (radiance along `direction`).
struct WaterSeen {
    /// Radiance that does not come along `direction`.
    own: vec3f,
    /// Part of the radiance along `direction` that is seen, 0 .. 1.
    passed: vec3f,
    /// Where the ray goes on to: unit vector, upward.
    direction: vec3f,
    /// How far up and down from it light comes from, too (rad, standard deviation).
    blur: f32,
}

/// Irradiance of level water to which the land leaves `sun_seen` of the sun.
fn water_irradiance(day: Daylight, sun_seen: f32) -> vec3f {
    return sun_seen * max(day.to_sun.y, 0.0) * day.sun + day.sky;
}

/// How deep (m) the ground of slope `slope` must lie for the water over it to look like water: what a pixel covers of it.
fn water_edge(footprint: f32, slope: f32) -> f32 {
    return clamp(footprint * min(slope, 1.0), 0.03, 4.0);
}

/// Water at `position` (m), seen from above in the unit `direction` by a pixel that covers `footprint` (m) of it.
///
/// `bed` is the radiance of the ground seen through it, as if it were dry; it lies `depth` (m) below the point of the
/// surface, and `bed_depth` (m) below the level where the refracted ray meets it. `edge` is from `water_edge`. For depth
/// 0 what is seen is `bed`: the waterline has no step.
fn water_seen_from_above(
    position: vec3f,
    direction: vec3f,
    footprint: f32,
    bed: vec3f,
    depth: f32,
    bed_depth: f32,
    edge: f32,
    day: Daylight,
    sun_seen: f32,
) -> WaterSeen {
    let waves = water_surface_waves(position.xz, footprint);
    let mirror = water_mirror(direction, waves, day, sun_seen);
    let presence = water_presence(depth, edge);
    let irradiance = water_irradiance(day, sun_seen);
    let path = max(bed_depth, 0.0) / max(-water_refracted_down(direction).y, 0.1);
    let under = water_over_ground(bed, presence, max(bed_depth, 0.0), path, irradiance);
    let foam = max(shore_foam(position.xz, depth, footprint), 0.8 * presence * waves.foam);
    let water_part = presence * (1.0 - foam);
    let reflected = mirror.reflectance * water_part;
    let white = foam * FOAM_ALBEDO * irradiance / 3.14159265;
    let own = under * (1.0 - foam) * (1.0 - presence * mirror.reflectance) + water_part * mirror.glint + white;
    return WaterSeen(own, vec3f(reflected), mirror.direction, mirror.blur);
}

/// Radiance of water lit from above, seen from inside of it, at `y` (m) above sea level.
fn water_glow(y: f32, day: Daylight) -> vec3f {
    return water_deep_radiance(water_irradiance(day, 1.0)) * water_transmittance(max(water.level - y, 0.0));
}

/// The surface seen from below in the unit `direction` (`direction.y` > 0), `distance` (m) away from an eye at `origin_y`.
///
/// Inside of Snell's window the world above is seen, squeezed together; outside of it the water mirrors its own depth.
fn water_seen_from_below(position: vec3f, direction: vec3f, distance: f32, origin_y: f32, day: Daylight) -> WaterSeen {
    let waves = water_surface_waves(position.xz, water_footprint(distance, direction));
    let normal = normalize(vec3f(-waves.slope.x, 1.0, -waves.slope.y));
    let cos_theta = clamp(dot(normal, direction), 0.0, 1.0);
    let reflectance = fresnel_dielectric(cos_theta, 1.0 / WATER_IOR);
    let sin2 = WATER_IOR * WATER_IOR * (1.0 - cos_theta * cos_theta);
    let aside = WATER_IOR * (direction - cos_theta * normal);
    var out = aside + sqrt(max(1.0 - sin2, 0.0)) * normal;
    out.y = max(out.y, 0.002);
    let left = water_transmittance(distance);
    let glow = water_glow(origin_y, day);
    return WaterSeen(glow * (1.0 - left * (1.0 - reflectance)), left * (1.0 - reflectance), normalize(out), 0.0);
}

/// Ground with radiance `bed` in air, seen from inside of the water, `distance` (m) away and `depth` (m) down.
fn water_around(bed: vec3f, distance: f32, depth: f32, origin_y: f32, day: Daylight) -> vec3f {
    let left = water_transmittance(distance);
    return bed * water_transmittance(max(depth, 0.0)) * left + water_glow(origin_y, day) * (1.0 - left);
}
