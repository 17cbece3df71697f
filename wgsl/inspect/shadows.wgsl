// Where the sun is seen: sunlit ground is cream, ground in the shadow of other land blue, ground turned away violet.

#include <color/srgb.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>
#include <sky/sky.wgsl>

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Half shadows lie between cream and
/// blue; slopes are shaded a little, so that the land's forms are seen.
fn main_image(frag_coord: vec2f) -> vec4f {
    let sight = inspect_sight(frag_coord);
    var color = SCALE_NOTHING;
    if sight.hit {
        let met = inspect_ground(sight);
        let day = sky_daylight(met.position);
        let seen = terrain_shadow(met.position, met.normal, sight.footprint, day);
        let faces = dot(met.normal, day.to_sun);
        let shaded = select(vec3f(0.10, 0.16, 0.42), vec3f(0.16, 0.07, 0.20), faces <= 0.0);
        color = mix(shaded, vec3f(0.90, 0.80, 0.58), seen) * (0.55 + 0.45 * met.normal.y);
    }
    return vec4f(srgb_encode(color), 1.0);
}
