// ---- p ----
/// Leaves.
/// And this.
const p_x: f32 = 1.0;
const p_y: f32 = 2.0;
/// Leaves.
const p_z: f32 = 3.0;

// ---- input.wgsl ----
// A remark that stays.
/// Stays: it is the function's.
fn f() -> f32 { return p_x; }

/// Set off by a blank line: stays.

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f() + p_y + p_z);
}
