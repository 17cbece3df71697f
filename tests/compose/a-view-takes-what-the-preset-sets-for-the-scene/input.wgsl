#include "land.wgsl"

/// How bright.
#param sky.zenith: f32 = 0.3
/// Which light.
#param color.warm: vec3f = (1, 0.8, 0.6)

fn main_image(p: vec2f) -> vec4f { return vec4f(sky.zenith * color.warm, land.height); }
