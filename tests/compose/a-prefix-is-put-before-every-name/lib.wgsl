const workgroup = 8u;

/// One step.
fn lib_step(x: f32) -> f32 {
    return x + 1.0;
}
