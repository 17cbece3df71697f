// ---- p ----
/// Documented.
const p_x: f32 = 1.0;
const p_y: f32 = 2.0;

// ---- a.wgsl ----


fn a() -> f32 { return 1.0; }

// ---- input.wgsl ----
// Head.

// Stays with the function.
fn f() -> f32 {

    let a = p_x;

    return a;
}

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f() + p_y + a());
}
