// Fraction and whole part, both with the number's sign, in a structure.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = (floor(at.x) - 32.0) * 0.375;
    let y = floor(at.y) * 0.5 - 7.25;
    let a = modf(x);
    let b = modf(vec3f(x, y, -1.75));
    return vec4f(a.fract + a.whole * 4.0, b.fract.y + b.whole.y * 4.0, b.fract.z + b.whole.x, modf(y).whole);
}
