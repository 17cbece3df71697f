// A landscape: land and water under a clear sky.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <sky/cirrus.wgsl>
#include <sky/gradient.wgsl>
#include <terrain/height.wgsl>
#include <terrain/shade.wgsl>

/// Whether the land is flooded up to `water.level`.
#option landscape.water = false

#if landscape.water
#include <water/level.wgsl>
#include <water/shade.wgsl>
#endif

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m); `terrain.far` for the sky.
    distance: f32,
}

#if landscape.water
/// What is seen from `origin` (m) in the unit `direction`.
///
/// A loop of two rays, the second from the water on: compilers copy every function into each place that it is called from,
/// so that the land is looked for in one place only.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    let submerged = origin.y < water.level;
    var start = origin;
    var toward = direction;
    var gone = 0.0; // way (m) of the first ray, if there is a second
    var radiance = vec3f(0.0); // of the last ray
    var distance = terrain.far; // of the first
    var surface = WaterSeen(vec3f(0.0), vec3f(1.0), direction); // what the first ray sees on its way to the second
    var in_air = false; // whether the first ray ended on water seen from above

    for (var bounce = 0; bounce < 2; bounce++) {
        let land = terrain_trace(start, toward);

        // Water before it? The land's march ends within half a pixel of the ground: near the waterline the depth decides.
        var wet = false;
        var way = land.distance;
        var depth = 0.0;
        if bounce == 0 {
            let water_ahead = water_trace(start, toward, terrain.far);
            let slack = 0.5 * terrain_footprint(way);
            wet = water_ahead.hit
                && (!land.hit || water_ahead.distance < way || start.y + way * toward.y < water.level + slack);
            if wet {
                let crossing = start + water_ahead.distance * toward;
                depth = crossing.y - terrain_height_filtered(crossing.xz, terrain_footprint(water_ahead.distance));
                wet = depth > 0.0 && (!submerged || water_ahead.distance < way);
            }
            way = select(way, water_ahead.distance, wet);
            distance = way;
        }
        let end = start + way * toward;
        let footprint = terrain_footprint(gone + way);

        // The ground there: at the end of the ray, or under the water, where its refraction leads to.
        var spot = end.xz;
        var lit = end;
        var slope = 0.0;
        var bed = vec3f(0.0);
        var sun_seen = 1.0;
        if wet {
            let down = water_refracted_down(toward);
            spot += depth * down.xz / max(-down.y, 0.1);
        }
        if land.hit || wet {
            let relief = terrain_height_grad_filtered(spot, footprint);
            let normal = normalize(vec3f(-relief.y, 1.0, -relief.z));
            let position = vec3f(spot.x, relief.x, spot.y);
            slope = length(relief.yz);
            lit = position;
            let shadowed = select(position, end, wet); // the sun goes in where the eye looks in, near enough
            sun_seen = terrain_shadow(shadowed, select(normal, vec3f(0.0, 1.0, 0.0), wet), footprint);
            bed = terrain_shade(position, normal, footprint, sun_seen);
        }

        if wet && !submerged {
            let covered = water_footprint(way, toward);
            let bed_depth = max(end.y - lit.y, 0.0);
            let edge = water_edge(covered, slope);
            surface = water_seen_from_above(end, toward, covered, bed, depth, bed_depth, edge, sun_seen);
            in_air = true;
        } else if wet {
            surface = water_seen_from_below(end, toward, way, origin.y);
        } else if bounce == 0 && submerged {
            // Under water, and no surface ahead: the ground, or the deep.
            radiance = water_around(bed, way, water.level - lit.y, origin.y);
            break;
        } else {
            // What a ray through air sees.
            if land.hit {
                radiance = sky_veil(bed, start, toward, way);
            } else {
                // The sun's image in the water is its glint.
                let clear = sky_radiance(toward) + select(vec3f(0.0), sun_disc(toward), bounce == 0 || submerged);
                radiance = cirrus_veil(clear, start, toward);
            }
            break;
        }
        if max(max(surface.passed.x, surface.passed.y), surface.passed.z) < 0.002 {
            break; // nothing of a second ray would be seen
        }
        gone = way;
        toward = surface.direction;
        start = end + vec3f(0.0, max(0.02, 0.25 * footprint), 0.0);
    }
    let seen = surface.own + surface.passed * radiance;
    if in_air {
        return Traced(sky_veil(seen, origin, direction, distance), distance);
    }
    return Traced(seen, distance);
}
#else
/// What is seen from `origin` (m) in the unit `direction`.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    let hit = terrain_trace(origin, direction);
    if !hit.hit {
        let clear = sky_radiance(direction) + sun_disc(direction);
        return Traced(cirrus_veil(clear, origin, direction), terrain.far);
    }
    let footprint = terrain_footprint(hit.distance);
    let along = origin + hit.distance * direction;
    let land = terrain_height_grad_filtered(along.xz, footprint);
    let position = vec3f(along.x, land.x, along.z);
    let normal = normalize(vec3f(-land.y, 1.0, -land.z));
    let sun_seen = terrain_shadow(position, normal, footprint);
    let radiance = terrain_shade(position, normal, footprint, sun_seen);
    return Traced(sky_veil(radiance, origin, direction, hit.distance), hit.distance);
}
#endif

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, terrain_height(camera.position.xz));
    let seen = scene_trace(ray.origin, ray.direction);
    return vec4f(display_color(seen.radiance), 1.0);
}
