// The land from above, north at the top: height as colour, with contours, relief shading and what the camera sees.

#include <camera/camera.wgsl>
#include <color/srgb.wgsl>
#include <frame.wgsl>
#include <terrain/height.wgsl>
#include <inspect/extent.wgsl>
#include <inspect/scale.wgsl>

/// How strongly slopes are shaded, as if light came from the north-west.
#param inspect.relief: f32 = 0.7, range 0 .. 1

/// How far (pixels) `offset` (pixels from the camera) is from the ray that leaves the camera for the unit `direction`.
fn heights_from_ray(offset: vec2f, direction: vec2f) -> f32 {
    let along = max(dot(offset, direction), 0.0);
    return length(offset - along * direction);
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. The camera is in the middle.
fn main_image(frag_coord: vec2f) -> vec4f {
    let pixel = extent_pixel();
    let offset = (frag_coord - 0.5 * frame.resolution) * vec2f(1.0, -1.0); // east, south
    let land = terrain_height_grad_filtered(camera.position.xz + pixel * offset, pixel);
    let heights = extent_heights();
    let scale = Scale(heights.x, heights.y, false);
    let normal = normalize(vec3f(-land.y, 1.0, -land.z));
    let lit = dot(normal, normalize(vec3f(-0.5, 0.75, -0.5)));
    var color = scale_color(scale, land.x) * mix(1.0, clamp(1.35 * lit, 0.1, 1.4), inspect.relief);

    let interval = scale_step(heights.y - heights.x, 10.0);
    let from_contour = abs(fract(land.x / interval + 0.5) - 0.5) * interval;
    let slope = max(length(land.yz), 1e-4);
    color *= mix(0.45, 1.0, smoothstep(0.3, 1.1, from_contour / (slope * pixel)));

    let half = 0.5 * frame.resolution;
    let ground_height = terrain_height(camera.position.xz);
    var edge = 1e9;
#if camera.projection == perspective
    for (var i = 0; i < 2; i++) { // the left and the right edge of the camera's picture
        let side = camera_ray(vec2f(f32(i) * frame.resolution.x, half.y), ground_height).direction.xz;
        edge = min(edge, heights_from_ray(offset, side / max(length(side), 1e-6)));
    }
#endif
    let mark = max(smoothstep(1.2, 0.4, edge), smoothstep(5.0, 4.0, length(offset)));
    color = mix(color, vec3f(1.0), mark);
    return vec4f(srgb_encode(saturate(scale_legend(scale, color, frag_coord))), 1.0);
}
