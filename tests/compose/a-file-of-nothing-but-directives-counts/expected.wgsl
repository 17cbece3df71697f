diagnostic(off, derivative_uniformity);

// ---- limits.wgsl ----
// A check, and no more.

const_assert 2 > 1;

// ---- input.wgsl ----
@compute @workgroup_size(1)
fn main() {
    _ = 1.0;
}
