fn value2(p: vec2f) -> f32 { return p.x; }
fn perlin2(p: vec2<f32>) -> f32 { return p.y; }
