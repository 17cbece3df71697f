
// ---- march.wgsl as march ----
struct march_Sample {
    t: f32,
}

fn march_run() -> f32 {
    return depth(march_Sample(1.0), array(1.0, 2.0));
}

// ---- input.wgsl ----
fn depth(s: march_Sample, w: array<f32, 2>) -> f32 {
    return s.t * w[0];
}

@compute @workgroup_size(1)
fn main() {
    _ = march_run();
}
