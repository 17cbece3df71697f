fn g(x: f32, y: vec2f) -> f32 { return x; }
fn f() -> f32 {
    return g(1.0);
}
