// The land cut along a line from west to east: its heights as a curve over filled ground; of a dual heightmap also the
// wide map (blue) and what the local one adds to it (green).

#include <camera/camera.wgsl>
#include <color/srgb.wgsl>
#include <frame.wgsl>
#include <terrain/height.wgsl>
#include <inspect/extent.wgsl>
#include <inspect/scale.wgsl>
#if terrain.dual
#include <terrain/mountains.wgsl>
#endif

/// How far south of the camera the cut is.
#param inspect.slice_z: f32 = 0.0, range -1000000 .. 1000000, unit m

/// How much of a pixel at `height` (m) the curve through the heights `ends` (m) of its two sides covers, 0 .. 1.
fn curve_ink(ends: vec2f, height: f32, pixel_height: f32) -> f32 {
    let outside = max(max(min(ends.x, ends.y) - height, height - max(ends.x, ends.y)), 0.0) / pixel_height;
    return smoothstep(1.5, 0.5, outside);
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. The camera is in the middle;
/// heights are stretched so that those from `inspect.low` to `inspect.high` fill the picture.
fn main_image(frag_coord: vec2f) -> vec4f {
    let pixel = extent_pixel();
    let heights = extent_heights();
    let margin = 0.06 * (heights.y - heights.x);
    let pixel_height = (heights.y - heights.x + 2.0 * margin) / frame.resolution.y;
    let height = heights.x - margin + frag_coord.y * pixel_height;
    let x = camera.position.x + (frag_coord.x - 0.5 * frame.resolution.x) * pixel;

    // Here and a pixel to the east: a loop around one call.
    var land = vec2f(0.0);
    var wide = vec2f(0.0);
    var rugged = vec2f(0.0);
    for (var i = 0; i < 2; i++) {
        let p = vec2f(x + f32(i) * pixel, camera.position.z + inspect.slice_z);
        land[i] = terrain_height_filtered(p, pixel);
#if terrain.dual
        let base = mountains_lie(p, min(terrain.octaves, log2(terrain.scale / (2.0 * pixel))));
        wide[i] = base.wide;
        rugged[i] = base.land.x - base.wide;
#endif
    }
    let above = (height - land.x) / pixel_height;
    let depth = clamp(-above * pixel_height / (heights.y - heights.x), 0.0, 1.0);
    let earth = mix(vec3f(0.20, 0.15, 0.10), vec3f(0.07, 0.05, 0.04), sqrt(depth));
    let air = vec3f(0.55, 0.62, 0.70);
    var color = mix(earth, air, clamp(above + 0.5, 0.0, 1.0));
#if terrain.dual
    color = mix(color, vec3f(0.10, 0.62, 0.22), curve_ink(rugged, height, pixel_height));
    color = mix(color, vec3f(0.06, 0.22, 0.80), curve_ink(wide, height, pixel_height));
#endif
    color = mix(color, vec3f(0.9, 0.32, 0.05), curve_ink(land, height, pixel_height));

    // Lines at round heights and places, the heights with their numbers.
    let up = scale_step(heights.y - heights.x, 5.0);
    let east = scale_step(pixel * frame.resolution.x, 8.0);
    let nearest = round(height / up) * up;
    let from_height = abs(height - nearest) / pixel_height;
    let from_place = abs(fract(x / east + 0.5) - 0.5) * east / pixel;
    let is_sea = abs(nearest) < 0.5 * up;
    color *= mix(select(0.80, 0.35, is_sea), 1.0, smoothstep(0.5, 1.0, from_height));
    color *= mix(0.80, 1.0, smoothstep(0.5, 1.0, from_place));
    let cell = scale_cell();
    let at = vec2f(28.0 * cell - frag_coord.x, (height - nearest) / pixel_height - 2.0 * cell) / cell;
    if number_inked(vec2i(floor(at)), nearest) {
        color = vec3f(0.95);
    }

    // The camera, where the cut goes through it.
    let eye = camera_ray(0.5 * frame.resolution, terrain_height(camera.position.xz)).origin;
    let from_eye = vec2f(frag_coord.x - 0.5 * frame.resolution.x, (height - eye.y) / pixel_height);
    if inspect.slice_z == 0.0 {
        color = mix(color, vec3f(1.0), smoothstep(5.0, 4.0, length(from_eye)));
    }
    return vec4f(srgb_encode(color), 1.0);
}
