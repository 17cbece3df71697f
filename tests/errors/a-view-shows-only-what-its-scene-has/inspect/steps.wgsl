// How often; the snow is not read.
#include <land.wgsl>
#include <frame.wgsl>

/// At most.
#param inspect.most_steps: f32 = 9.0

fn main_image(p: vec2f) -> vec4f { return vec4f(land.height, water.level, inspect.most_steps, frame.time); }
