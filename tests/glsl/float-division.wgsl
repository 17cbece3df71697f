// tolerance: 3e-7 relative, since WGSL's division may err by 2.5 ulp
// Of scalars, vectors and both.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = floor(at.x) + 0.5;
    let b = floor(at.y) - 31.5;
    return vec4f(a / b, 1.0 / a, (vec2f(a, b) / vec2f(b, 3.0)).y, select((vec3f(a) / 7).z, (2 / vec2f(a, b)).y, b > 0.0));
}
