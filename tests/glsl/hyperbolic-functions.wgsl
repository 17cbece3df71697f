// tolerance: 1e-4 relative, since WGSL's hyperbolics inherit the errors of exp, log and their differences
// sinh, cosh, tanh, and asinh, acosh, atanh.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = (floor(at.x) + 8.0) / 16.0;
    let y = floor(at.y) / 4.0 + 1.5;
    return vec4f(
        sinh(x) + asinh(x),
        cosh(x) + tanh(x),
        acosh(y) + sinh(vec2f(x, 1.0)).y,
        atanh(1.0 / y) + tanh(vec3f(x, y, 1.0)).y + cosh(vec2f(1.0, x)).x,
    );
}
