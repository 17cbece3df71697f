@group(0) @binding(0) var colour: texture_2d<f32>;
@group(0) @binding(1) var linear: sampler;
@group(0) @binding(2) var depth: texture_depth_2d;
@group(0) @binding(3) var shadow: sampler_comparison;
@group(0) @binding(4) var volume: texture_3d<f32>;
@fragment
fn main(@location(0) uv: vec2f) -> @location(0) vec4f {
    let s = textureSampleCompareLevel(depth, shadow, uv, 0.5);
    let v = textureLoad(volume, vec3i(1, 2, 3), 0);
    return textureSampleLevel(colour, linear, uv, 0.0) * s + v;
}
