/// Becomes a function of WGSL itself.
fn ix() -> f32 {
    return 1.0;
}

const od = 1;
