
// ---- lib/two.wgsl ----
fn two() -> f32 { return 0.5; }

// ---- deep/one.wgsl ----
fn one() -> f32 { return two(); }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(one());
}
