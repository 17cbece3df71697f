// tolerance: 5e-4 absolute, since WGSL's sin and cos may err by 2^-11 within ±pi
// In radians.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = (floor(at.x) - 32.0) * 0.09;
    let b = (floor(at.y) - 32.0) * 0.03;
    return vec4f(sin(a), cos(a), tan(b), sin(vec2f(a, b)).y * cos(vec3f(a, b, 0.0)).y);
}
