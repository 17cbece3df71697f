fn perlin2(p: vec2<f32>, seed: u32) -> vec3<f32> { return vec3f(); }
const NOISE = 1;
fn silent(p: vec2f) {}
