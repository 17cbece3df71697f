// Intersection distance error: how far along the ray the march ended from where the ray truly meets the land, as
// colour. Green: the march found land where there is none, or none where there is.

#include <color/srgb.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>
#include <inspect/truth.wgsl>

/// Error at the dark end of the scale.
#param inspect.ide_low: f32 = 0.01, range 0.000001 .. 1000, log, unit m
/// Error at the light end of the scale.
#param inspect.ide_high: f32 = 1000.0, range 0.00001 .. 100000, log, unit m

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Costly: a dense march a pixel.
/// Grey is where that march ran out of steps, and the truth is not known.
fn main_image(frag_coord: vec2f) -> vec4f {
    let scale = Scale(inspect.ide_low, max(inspect.ide_high, 1.001 * inspect.ide_low), true);
    let sight = inspect_sight(frag_coord);
    let truth = inspect_truth(sight.origin, sight.direction);
    var color = SCALE_NOTHING;
    if !truth.known {
        color = vec3f(0.3);
    } else if truth.hit != sight.hit {
        color = vec3f(0.02, 0.75, 0.10);
    } else if truth.hit {
        color = scale_color(scale, abs(sight.distance - truth.distance));
    }
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
}
