fn f(x: f32) -> f32 {
    let wide = vec2f(x);
    return clamp(x > 1.0, 0.0, 1.0) + length(wide) + x;
}
