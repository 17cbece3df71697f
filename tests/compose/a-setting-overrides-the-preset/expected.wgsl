// ---- a ----
const a_x: f32 = 3.0;
const a_v: vec3f = vec3f(1.0, 2.0, 3.0);

// ---- input.wgsl ----
@fragment
fn main() -> @location(0) vec4f {
    return vec4f(a_v, a_x);
}
