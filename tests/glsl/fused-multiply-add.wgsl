// ES 3.00 has no fma; whole numbers, so that it does not count where it is rounded.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    return vec4f(fma(p.x, p.y, 1.0), fma(p, vec2f(2.0, -3.0), p.yx), fma(vec3f(p, 1.0), vec3f(4.0), vec3f(0.5)).z);
}
