// ---- cirrus_detail ----
const cirrus_detail_strength: f32 = 0.25;

// ---- inner.wgsl as cirrus_detail ----
fn cirrus_detail_inner() -> f32 {
    return cirrus_detail_strength;
}

// ---- outer.wgsl as cirrus ----
fn cirrus_outer() -> f32 {
    return cirrus_detail_strength * cirrus_detail_inner();
}

// ---- input.wgsl ----
@compute @workgroup_size(1)
fn main() {
    _ = cirrus_outer();
}
