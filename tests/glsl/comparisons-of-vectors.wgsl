// Component by component, giving a vector of booleans.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let p = vec2i(at.xy) - 30;
    let f = vec2f(p);
    let u = bitcast<vec2u>(p);
    let a = vec4<bool>(p == p.yx, p != p.yx);
    let b = vec4<bool>(p < vec2i(3, -4), f <= f.yx);
    let c = vec4<bool>(f > vec2f(1.0), u >= u.yx);
    let d = (p < vec2i(0)) == (p.yx < vec2i(5));
    return vec4i(bits(a), bits(b), bits(c), bits(vec4<bool>(d, (f != f.yx) != d)));
}

fn bits(v: vec4<bool>) -> i32 {
    return dot(vec4i(v), vec4i(1, 2, 4, 8));
}
