// How often.

/// At most.
#param inspect.most_steps: f32 = 9.0

fn main_image(p: vec2f) -> vec4f { return vec4f(inspect.most_steps); }
