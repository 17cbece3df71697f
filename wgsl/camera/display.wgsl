// From the light that reaches the camera to the numbers that a display takes.

#include <color/srgb.wgsl>
#include <color/tone_map.wgsl>

/// Exposure: each step doubles the light.
#param display.exposure: f32 = 1.0, range -16 .. 16, unit EV
/// How light beyond the display's white is brought back. `none` only encodes: decoded again it is linear light.
#option display.tone_map = exponential { exponential, none }

/// sRGB-encoded colour of linear `radiance`. 0 .. 1, with `display.tone_map = none` unbounded above.
fn display_color(radiance: vec3f) -> vec3f {
    let exposed = max(radiance, vec3f(0.0)) * exp2(display.exposure);
#if display.tone_map == exponential
    return srgb_encode(tone_map_exponential(exposed));
#else
    return srgb_encode(exposed);
#endif
}
