// From vector to vector, and vectors put together from scalars and vectors of every length.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = vec2i(at.xy);
    let a = vec2f(p);
    let b = vec4f(vec4i(p, p.yx));
    let c = vec3f(1.0, vec2f(p));
    let d = vec4f(a, c.xy);
    let e = vec4f(vec4<bool>(vec2<bool>(p.x < 3, true), p < vec2i(9)));
    return vec4f(a, b.zw) + d * 100.0 + vec4f(c, 0.5) * 0.25 + e.wzyx;
}
