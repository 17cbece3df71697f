// How far away the land is, as colour.

#include <color/srgb.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>

/// Distance at the dark end of the scale.
#param inspect.near: f32 = 10.0, range 0.001 .. 1000000, log, unit m
/// Distance at the light end of the scale; where it is not beyond `inspect.near`, `terrain.far`.
#param inspect.far: f32 = 0.0, range 0 .. 10000000, unit m

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let far = max(select(inspect.far, terrain.far, inspect.far <= inspect.near), 1.001 * inspect.near);
    let scale = Scale(inspect.near, far, true);
    let sight = inspect_sight(frag_coord);
    let color = select(SCALE_NOTHING, scale_color(scale, sight.distance), sight.hit);
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
}
