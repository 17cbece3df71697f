#include "march.wgsl" as march with probe = depth

fn depth(s: march_Sample, w: array<f32, 2>) -> f32 {
    return s.t * w[0];
}

@compute @workgroup_size(1)
fn main() {
    _ = march_run();
}
