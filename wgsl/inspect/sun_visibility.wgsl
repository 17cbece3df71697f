// How much of the sun reaches the ground that is seen, past other land and through the air: white is all of it, as outside
// of the air.

#include <color/srgb.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>
#include <sky/sky.wgsl>
#include <sun/key.wgsl>

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Ground that the sun does not reach is
/// blue; slopes are shaded a little, so that the land's forms are seen.
fn main_image(frag_coord: vec2f) -> vec4f {
    let sight = inspect_sight(frag_coord);
    var color = SCALE_NOTHING;
    if sight.hit {
        let met = inspect_ground(sight);
        let day = sky_daylight(met.position);
        let through = day.sun / max(key_light(), vec3f(1e-9));
        let visible = saturate(through * terrain_shadow(met.position, met.normal, sight.footprint, day));
        let none = vec3f(0.01, 0.02, 0.06);
        color = mix(none, vec3f(1.0), visible) * (0.55 + 0.45 * met.normal.y);
    }
    return vec4f(srgb_encode(color), 1.0);
}
