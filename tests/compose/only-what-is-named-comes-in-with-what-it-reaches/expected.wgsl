// ---- a ----
const a_x: f32 = 1.0;

// ---- input.wgsl ----
fn first() -> f32 {
    return third() + a_x;
}

fn third() -> f32 {
    return 3.0;
}
