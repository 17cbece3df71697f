// How thick the air is along each ray, up to the land or out of the air: its optical depth. A depth of 1 lets 37 % through.

#include <color/srgb.wgsl>
#include <inspect/channel.wgsl>
#include <inspect/look.wgsl>
#include <inspect/scale.wgsl>
#include <sky/sky.wgsl>

/// Optical depth at the dark end of the scale.
#param inspect.least_depth: f32 = 0.01, range 0.000001 .. 10, log
/// Optical depth at the light end of the scale, above `inspect.least_depth`.
#param inspect.most_depth: f32 = 10.0, range 0.00001 .. 80, log

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Grey: nothing comes through at all, as
/// where the planet is in the way.
fn main_image(frag_coord: vec2f) -> vec4f {
    let look = inspect_look(frag_coord);
    let left = sky_air(look.origin, look.direction, look.distance).transmittance;
    let depth = -log(clamp(left, vec3f(1e-37), vec3f(1.0)));
    let scale = Scale(inspect.least_depth, max(inspect.most_depth, 1.001 * inspect.least_depth), true);
#if inspect.channel == all
    let part = vec3f(scale_part(scale, depth.r), scale_part(scale, depth.g), scale_part(scale, depth.b));
    let color = select(SCALE_NOTHING, saturate(part), any(left > vec3f(0.0)));
    return vec4f(srgb_encode(color), 1.0);
#else
    let measured = scale_color(scale, channel_of(depth));
    let color = select(SCALE_NOTHING, measured, channel_of(left) > 0.0);
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
#endif
}
