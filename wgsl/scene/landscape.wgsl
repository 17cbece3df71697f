// A landscape: land, woods and water under a clear sky.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <frame.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <quality.wgsl>
#include <scene/weather.wgsl>
#include <sky/air.wgsl>
#include <sky/sky.wgsl>
#include <terrain/height.wgsl>
#include <terrain/shade.wgsl>

/// Whether trees stand on the land.
#option landscape.trees = false
/// Whether the land is flooded up to `water.level`.
#option landscape.water = false
/// Whether things of a host's own throw shadows on the land: it lays a `scene/guests.wgsl` over the library's, which has none.
#option landscape.guests = false

#if landscape.trees
#include <trees/trees.wgsl>
#endif
#if landscape.water
#include <water/level.wgsl>
#include <water/shade.wgsl>
#endif
#if landscape.guests
#include <scene/guests.wgsl>
#endif

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m); `RAY_FAR` for the sky.
    distance: f32,
}

#if landscape.water
const LANDSCAPE_RAYS: i32 = 2; // the second from the water on
#else
const LANDSCAPE_RAYS: i32 = 1;
#endif
#if quality == low
const LANDSCAPE_WOODED: i32 = 1; // rays that see single trees; the others see the woods' colour on the ground
#else
const LANDSCAPE_WOODED: i32 = 2;
#endif

/// What is seen from `origin` (m) in the unit `direction`.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    return landscape_trace(origin, direction, 0.5);
}

/// As `scene_trace`; `jitter` is where in their first steps the marches through clouds begin, 0 .. 1: another one for each
/// pixel turns bands into fine noise.
///
/// A loop over the ray and its reflection: compilers copy every function into each place that it is called from, so
/// everything is looked for, shadowed and lit in one place only.
fn landscape_trace(origin: vec3f, direction: vec3f, jitter: f32) -> Traced {
    var start = origin;
    var toward = direction;
    var gone = 0.0; // way (m) of the first ray, if there is a second
    var distance = RAY_FAR; // of the first
    var radiance = vec3f(0.0); // what is seen so far
    var passed = vec3f(1.0); // part of what the next ray sees that will be seen
    var blur = 0.0; // how far up and down the next ray stands for others (rad)
#if landscape.water
    let submerged = origin.y < water.level;
#endif

    for (var bounce = 0; bounce < LANDSCAPE_RAYS; bounce++) {
#if landscape.trees
        let clearance = trees_clearance();
#else
        let clearance = 0.0;
#endif
        let approach = terrain_approach(start, toward, select(1.0, LAND_MIRRORED, bounce > 0), clearance);
        let land = approach.hit;
        var way = land.distance;
        var wet = false; // whether the ray meets water first
        var leafy = false; // whether it meets a tree first

#if landscape.water
        // The land's march ends within half a pixel of the ground: near the waterline the depth decides, at the nearer of
        // its end and the water's surface. (Beyond its end, the surface may be that of another lake behind a mountain.)
        var depth = 0.0;
        if bounce == 0 {
            let slack = 0.5 * terrain_footprint(way);
            let water_ahead = water_trace(start, toward, max(terrain.far, way + slack));
            let is_first = !land.hit || water_ahead.distance < way;
            let reached = min(water_ahead.distance, way);
            wet = water_ahead.hit && (is_first || start.y + way * toward.y < water.level + slack);
            if wet {
                let crossing = start + reached * toward;
                depth = water.level - terrain_height_filtered(crossing.xz, terrain_footprint(reached));
                wet = depth > 0.0 && (!submerged || is_first);
            }
            way = select(way, reached, wet);
        }
#endif
#if landscape.trees
        // Where the mirrored ray is to see no trees, it looks for them nowhere.
        let tree = trees_trace(start, toward, approach.clear, select(way, 0.0, bounce >= LANDSCAPE_WOODED));
        if tree.hit {
            leafy = true;
            wet = false;
            way = tree.distance;
        }
#endif
        let ends = land.hit || wet || leafy;
        if bounce == 0 && ends {
            distance = way;
        }
        let end = start + way * toward;
        let footprint = terrain_footprint(gone + way);
        let day = weather_daylight(select(origin, end, ends));

        // What is lit there: the tree, the ground at the end of the ray, or the ground under the water, to where its
        // refraction leads.
        var spot = end.xz;
        var position = end;
        var normal = day.to_sun;
        var slope = 0.0;
        var lit = vec3f(0.0);
        var sun_seen = 1.0;
#if landscape.water
        if wet {
            let down = water_refracted_down(toward);
            spot += depth * down.xz / max(-down.y, 0.1);
        }
#endif
        if ends {
            if !leafy {
                let relief = terrain_height_grad_filtered(spot, footprint);
                normal = normalize(vec3f(-relief.y, 1.0, -relief.z));
                position = vec3f(spot.x, relief.x, spot.y);
                slope = length(relief.yz);
            }
            // The sun goes into water where the eye looks in, near enough.
            let shadowed = select(position, end, wet);
            // Clouds first: under a closed layer there is no sun whose shadows are worth a march.
            sun_seen = weather_sun_seen(shadowed, day);
            if sun_seen > 0.0 {
                sun_seen *= terrain_shadow(shadowed, select(normal, vec3f(0.0, 1.0, 0.0), wet), footprint, day);
            }
#if landscape.guests
            if sun_seen > 0.0 {
                sun_seen *= guests_shadow(shadowed, day.to_sun);
            }
#endif
#if landscape.trees
            if sun_seen > 0.0 && bounce < LANDSCAPE_WOODED {
                sun_seen *= trees_shadow(shadowed, footprint, day);
            }
            if leafy {
                lit = trees_shade(start, toward, tree, day, sun_seen);
            }
#endif
            if !leafy {
                lit = terrain_shade(position, normal, footprint, day, sun_seen);
            }
        } else {
            lit = sky_beyond(toward);
        }

#if landscape.water
        var through = vec3f(0.0); // part of what the next ray sees that the water lets the eye see
        var onward = toward;
        var onward_blur = 0.0;
        if wet && !submerged {
            let covered = water_footprint(way, toward);
            let bed_depth = max(end.y - position.y, 0.0);
            let edge = water_edge(covered, slope);
            let seen = water_seen_from_above(end, toward, covered, lit, depth, bed_depth, edge, day, sun_seen);
            lit = seen.own;
            through = seen.passed;
            onward = seen.direction;
            onward_blur = seen.blur;
        } else if wet {
            let seen = water_seen_from_below(end, toward, way, origin.y, day);
            lit = seen.own;
            through = seen.passed;
            onward = seen.direction;
        } else if bounce == 0 && submerged {
            // Under water, and no surface ahead: the ground, or the deep.
            lit = water_around(lit, way, water.level - position.y, origin.y, day);
        } else if !ends && bounce > 0 && !submerged {
            lit = vec3f(0.0); // the sun's image in water is its glint
        }
        let in_air = bounce > 0 || !submerged;
#else
        let in_air = true;
#endif

        // The way there is air, unless the eye is under water and looks at it.
        if in_air {
            let air = weather_air_blurred(start, toward, select(RAY_FAR, way, ends), jitter, blur, day);
            radiance += passed * (air.from_sun + air.from_sky);
            passed *= air.transmittance;
        }
        radiance += passed * lit;
#if landscape.water
        passed *= through;
        if max(max(passed.x, passed.y), passed.z) < 0.002 {
            break; // nothing of a second ray would be seen
        }
        gone = way;
        toward = onward;
        blur = onward_blur;
        start = end + vec3f(0.0, max(0.02, 0.25 * footprint), 0.0);
#endif
    }
    return Traced(radiance, distance);
}

/// The light that falls on a thing of a host's own at `position` (m), seen from `distance` (m) away: the sun, as far as land,
/// trees and clouds leave it, and the sky. What the host's things keep from each other is the host's.
fn scene_daylight(position: vec3f, distance: f32) -> Daylight {
    var day = weather_daylight(position);
    let footprint = terrain_footprint(distance);
    var seen = weather_sun_seen(position, day);
    if seen > 0.0 {
        seen *= terrain_shadow(position, day.to_sun, footprint, day);
    }
#if landscape.trees
    if seen > 0.0 {
        seen *= trees_shadow(position, footprint, day);
    }
#endif
    day.sun *= seen;
    return day;
}

/// Air and clouds between `origin` (m) and what a host draws `distance` (m) away in the unit `direction`; `sky_through` has a
/// radiance seen through them.
fn scene_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
    return weather_air(origin, direction, distance, 0.5, weather_daylight(origin + distance * direction));
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, terrain_height(camera.position.xz));
    let jitter = interleaved_gradient_noise(frag_coord, frame.index);
    let seen = landscape_trace(ray.origin, ray.direction, jitter);
    return vec4f(display_color(seen.radiance, frag_coord), 1.0);
}
