// What the march through the clouds costs: how often it asks for their density along each ray, or how many steps it takes.

#include <camera/camera.wgsl>
#include <clouds/layer.wgsl>
#include <color/srgb.wgsl>
#include <frame.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <sun/key.wgsl>
#include <inspect/look.wgsl>
#include <inspect/scale.wgsl>

/// What is counted: densities asked for, those on the way to the sun included, or steps along the ray.
#option inspect.count = evaluations { evaluations, steps }
/// The number at the light end of the scale.
#param inspect.most_evaluations: f32 = 200.0, range 1 .. 100000, log

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Grey: the ray does not come near
/// clouds.
fn main_image(frag_coord: vec2f) -> vec4f {
    let look = inspect_look(frag_coord);
    let span = cloud_ahead(look.origin, look.direction);
    let end = min(span.y, look.distance);
    let scale = Scale(0.0, inspect.most_evaluations, false);
    var color = SCALE_NOTHING;
    if span.x < end {
        var how = cloud_effort();
        how.pixel_angle = camera_pixel_angle();
        let jitter = interleaved_gradient_noise(frag_coord, frame.index);
        let to_sun = key_direction();
        let seen = cloud_volume_march(look.origin, look.direction, span.x, end, to_sun, jitter, how);
#if inspect.count == steps
        color = scale_color(scale, f32(seen.steps));
#else
        color = scale_color(scale, f32(seen.evaluations));
#endif
    }
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
}
