
// ---- low.wgsl ----
fn value() -> f32 { return 0.5; }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(value());
}
