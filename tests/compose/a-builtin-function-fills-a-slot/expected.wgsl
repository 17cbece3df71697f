
// ---- apply.wgsl ----
fn applied(x: f32) -> f32 { return sqrt(abs(x)); }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(applied(-1.0));
}
