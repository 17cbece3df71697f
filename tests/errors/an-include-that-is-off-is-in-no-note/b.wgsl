fn b() -> f32 {
    return nothing;
}
