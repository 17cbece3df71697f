
// ---- noise.wgsl ----
fn noise(x: f32) -> f32 {
    return x;
}

// ---- fbm.wgsl as relief ----
fn relief_fbm(x: f32) -> f32 {
    return noise(x) + sin(x);
}

// ---- input.wgsl ----
fn relief_noise(x: f32) -> f32 {
    return 0.0;
}

fn relief_sin(x: f32) -> f32 {
    return 0.0;
}

@compute @workgroup_size(1)
fn main() {
    _ = relief_fbm(1.0) + relief_noise(1.0) + relief_sin(1.0);
}
