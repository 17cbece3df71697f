fn f() -> f32 {
    return vec2f(1.0);
}
