
// ---- a.wgsl ----
fn a() -> f32 {
    return 1.0;
}

// ---- b.wgsl ----
fn b() -> f32 {
    return 2.0;
}
