fn b() -> f32 {
    return 2.0;
}
