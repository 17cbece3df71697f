#slot noise2: fn(p: vec2f) -> f32

fn fbm2(p: vec2f) -> f32 {
    let sum: f32 = noise2(p) * p;
    return sum;
}
