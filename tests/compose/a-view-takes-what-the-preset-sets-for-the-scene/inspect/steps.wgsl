// How often. The scene's groups that it knows nothing of are no names to it: `color` is its own.

#include <land.wgsl>

/// At most.
#param inspect.most_steps: f32 = 9.0

fn main_image(p: vec2f) -> vec4f {
    let color = land.height / inspect.most_steps;
    return vec4f(color);
}
