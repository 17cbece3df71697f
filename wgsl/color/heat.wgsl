// Numbers as colours: from a dark blue by way of red to a light yellow.

#include <color/oklab.wgsl>

/// Linear sRGB for `part`, 0 (dark blue) .. 1 (light yellow), held there: 0 .. 1 in each channel.
///
/// Equal steps of `part` look equal (in Oklab the longest is at most 1.1 times the shortest), and it is still read
/// right without colours: lightness goes evenly from 0.20 to 0.96 while the hue turns one way, within sRGB.
fn heat_color(part: f32) -> vec3f {
    let t = clamp(part, 0.0, 1.0);
    let hue = mix(4.8869219, 8.0634217, t); // 280° to 462°
    let chroma = 0.07 + 0.40 * t * (1.0 - t);
    return saturate(oklab_to_linear(vec3f(mix(0.20, 0.96, t), chroma * cos(hue), chroma * sin(hue))));
}
