// tolerance: 1e-5 relative, since WGSL's exp may err by 3 + 2|x| ulp, pow by exp2(y * log2(x))
// exp, exp2, log, log2, pow.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = (floor(at.x) - 32.0) / 8.0;
    let y = floor(at.y) / 4.0 + 2.0;
    return vec4f(
        exp(x),
        exp2(x),
        log(y) * log2(y + 1.0),
        pow(y, x) + pow(vec2f(y, 2.0), vec2f(0.5, y / 8.0)).y + log(vec2f(y)).x + exp2(vec2f(y / 4.0, 1.0)).x,
    );
}
