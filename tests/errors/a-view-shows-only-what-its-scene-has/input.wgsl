#include <frame.wgsl>

/// How bright.
#param sky.zenith: f32 = 0.3

fn main_image(p: vec2f) -> vec4f { return vec4f(sky.zenith * frame.time); }
