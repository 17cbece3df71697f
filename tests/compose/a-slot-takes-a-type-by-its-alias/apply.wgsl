#slot noise2: fn(p: vec2f) -> f32
fn applied() -> f32 { return noise2(vec2f(1.0)); }
