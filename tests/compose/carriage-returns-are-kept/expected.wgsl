// ---- p ----
/// Doc.
const p_x: f32 = 1.0;

// ---- a.wgsl ----
// A.

fn a() -> f32 {
    return 1.0;
}

// ---- input.wgsl ----
// Head.

@fragment
fn main() -> @location(0) vec4f {
    return vec4f(p_x + a());
}
