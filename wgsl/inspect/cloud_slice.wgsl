// The clouds cut: their density on a plane, upright along the camera's azimuth, or level as on a map.

#include <camera/camera.wgsl>
#include <clouds/layer.wgsl>
#include <color/srgb.wgsl>
#include <frame.wgsl>
#include <math/rotation.wgsl>
#include <inspect/scale.wgsl>

/// How the clouds are cut: `upright` from the camera on to where it looks, or `level` around the camera, north at the top.
#option inspect.cut = upright { upright, level }
/// How much the picture shows from its left to its right edge; 0 is ten times `clouds.scale`.
#param inspect.cut_width: f32 = 0.0, range 0 .. 10000000, unit m
/// At which height in the layer a level cut is: 0 is the base, 1 the top.
#param inspect.cut_height: f32 = 0.35, range 0 .. 1
/// Density at the light end of the scale; the clouds' own go up to 1.
#param inspect.most_density: f32 = 1.0, range 0.001 .. 1

/// The place (m) that is cut at `frag_coord` (pixels from the bottom left). Upright, heights are stretched so that the layer
/// fills the picture, with a margin.
fn cut_position(frag_coord: vec2f) -> vec3f {
    let pixel = select(inspect.cut_width, 10.0 * clouds.scale, inspect.cut_width <= 0.0) / frame.resolution.x;
#if inspect.cut == level
    let offset = (frag_coord - 0.5 * frame.resolution) * pixel;
    let height = clouds.base + inspect.cut_height * clouds.thickness;
    return vec3f(camera.position.x + offset.x, height, camera.position.z - offset.y);
#else
    let ahead = frag_coord.x * pixel * camera_ray(0.5 * frame.resolution, 0.0).direction.xz;
    let height = clouds.base + (1.2 * frag_coord.y / frame.resolution.y - 0.1) * clouds.thickness;
    return vec3f(camera.position.x + ahead.x, height, camera.position.z + ahead.y);
#endif
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let density = cloud_density(cut_position(frag_coord));
    let scale = Scale(0.0, inspect.most_density, false);
    var color = scale_color(scale, density);
#if inspect.cut == level
    let from_camera = length(frag_coord - 0.5 * frame.resolution);
    color = mix(color, vec3f(1.0), smoothstep(5.0, 4.0, from_camera));
#else
    // The layer's lower and upper side.
    let part = 1.2 * frag_coord.y / frame.resolution.y - 0.1;
    let from_side = min(abs(part), abs(part - 1.0)) / 1.2 * frame.resolution.y;
    color = mix(color, vec3f(0.4), smoothstep(1.0, 0.5, from_side));
#endif
    return vec4f(srgb_encode(scale_legend(scale, color, frag_coord)), 1.0);
}
