// The result's member is taken from the call at once, in a larger expression, in a loop, and passed on.

fn twice(x: f32) -> f32 {
    return x * 2.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x) * 0.75 - 20.0;
    var sum = 0.0;
    for (var i = 0; i < 3; i++) { sum += modf(x + f32(i) * 0.25).fract + twice(frexp(x).fract); }
    let e = frexp(vec4f(x, at.y, 4.0, 0.25)).exp;
    let f = frexp(x + 0.5);
    let again = f;
    return vec4f(sum, modf(x).whole * 2.0 + modf(vec2f(x, 2.5)).fract.y, f32(e.x * 100 + e.z + e.w), again.fract * f32(f.exp));
}
