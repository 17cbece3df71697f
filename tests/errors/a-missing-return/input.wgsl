fn f(x: f32) -> f32 {
    if x > 1.0 { return 1.0; }
}
