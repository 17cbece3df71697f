
// ---- deep/two.wgsl ----
fn two() -> f32 { return 0.5; } // beside

// ---- top.wgsl ----
fn top() -> f32 { return 0.125; }

// ---- deep/one.wgsl ----
fn one() -> f32 { return two() + top(); }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(one());
}
