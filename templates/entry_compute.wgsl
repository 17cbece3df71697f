// The scene as a picture: a compute shader that writes a texture, 8×8 pixels a workgroup.

#include <frame.wgsl>

@group(0) @binding(1) var picture: texture_storage_2d<rgba8unorm, write>;

/// The colour of a pixel, sRGB-encoded. Dispatch ceil(width / 8) × ceil(height / 8) workgroups.
@compute @workgroup_size(8, 8)
fn compute_main(@builtin(global_invocation_id) id: vec3u) {
    if all(id.xy < textureDimensions(picture)) {
        let pixel = vec2f(id.xy) + 0.5 + frame.jitter;
        textureStore(picture, id.xy, main_image(vec2f(pixel.x, frame.resolution.y - pixel.y)));
    }
}
