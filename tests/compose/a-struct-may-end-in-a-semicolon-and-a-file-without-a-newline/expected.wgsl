
// ---- lib.wgsl ----
struct S { x: f32 };
fn g() -> f32 { return 1.0; }
// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(S(1.0).x + g());
}
