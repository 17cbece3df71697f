// How many steps the march took to find the land, or that there is none, as colour: heights, or single octaves where it
// goes octave by octave.

#include <color/srgb.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>

/// Steps at the light end of the scale.
#param inspect.most_steps: f32 = 320.0, range 1 .. 100000, log

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let scale = Scale(0.0, inspect.most_steps, false);
    let color = scale_color(scale, f32(inspect_sight(frag_coord).steps));
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
}
