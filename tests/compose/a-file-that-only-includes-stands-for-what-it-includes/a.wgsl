fn a() -> f32 {
    return 1.0;
}
