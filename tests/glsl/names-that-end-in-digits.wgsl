// Names that differ in a trailing number or underscore alone are different names.

const a1 = 1.0;
const a_1 = 10.0;
const a1_ = 100.0;
const a = 1000.0;

fn noise2(p2: f32) -> f32 {
    return p2 + 0.5;
}

fn noise(p: f32) -> f32 {
    return noise2(p) * 2.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    let x1 = x + 1.0;
    let x_1 = x1 * 2.0;
    let x2 = x_1 + x1 + x;
    return vec4f(a1 + a_1 + a1_ + a, noise2(x), noise(x1), x2);
}
