// How much of the light of what is seen comes through the air, 0 .. 1: of the land's, or of what shines behind the sky.

#include <color/srgb.wgsl>
#include <inspect/channel.wgsl>
#include <inspect/look.wgsl>
#include <inspect/scale.wgsl>
#include <sky/sky.wgsl>

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let look = inspect_look(frag_coord);
    let left = sky_air(look.origin, look.direction, look.distance).transmittance;
#if inspect.channel == all
    return vec4f(srgb_encode(left), 1.0); // white light that has come through
#else
    let scale = Scale(0.0, 1.0, false);
    let color = scale_color(scale, channel_of(left));
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
#endif
}
