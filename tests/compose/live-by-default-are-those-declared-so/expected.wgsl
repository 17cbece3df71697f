// ---- a ----
const a_y: f32 = 2.0;
struct OrogenParams {
    a_x: f32,
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(orogen.a_x + a_y);
}
