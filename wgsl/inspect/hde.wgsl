// Height difference error: how far above or below the land the march ended, |P.y - H(P.xz)|, as colour.

#include <color/srgb.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>
#include <inspect/truth.wgsl>

/// Error at the dark end of the scale.
#param inspect.hde_low: f32 = 0.001, range 0.000001 .. 1000, log, unit m
/// Error at the light end of the scale.
#param inspect.hde_high: f32 = 100.0, range 0.00001 .. 10000, log, unit m

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let scale = Scale(inspect.hde_low, max(inspect.hde_high, 1.001 * inspect.hde_low), true);
    let sight = inspect_sight(frag_coord);
    var color = SCALE_NOTHING;
    if sight.hit {
        let p = sight.origin + sight.distance * sight.direction;
        color = scale_color(scale, abs(p.y - inspect_true_height(p.xz, sight.distance)));
    }
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
}
