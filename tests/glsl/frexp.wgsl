// Fraction 0.5 .. 1 and exponent, in a structure; of zero both are zero.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = (floor(at.x) - 32.0) * 0.375;
    let s = 1.5 * exp2(floor(at.y) - 32.0);
    let a = frexp(x);
    let b = frexp(vec2f(x, s));
    return vec4f(a.fract + f32(a.exp) * 4.0, b.fract.y, f32(b.exp.y), b.fract.x + frexp(s).fract + f32(frexp(s).exp));
}
