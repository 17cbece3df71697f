fn g(x: f32, y: vec2f) -> f32 {
    return x + y.x;
}

fn f(x: f32) -> f32 {
    let wide = x * 2.0;
    return g(x, wide);
}
