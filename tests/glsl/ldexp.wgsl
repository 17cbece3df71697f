// A number times a power of two, exactly, from the smallest normal numbers to the greatest.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let m = 1.0 + floor(at.x) / 64.0;
    let e = i32(at.y) * 4 - 126;
    let v = ldexp(vec2f(m, -m), vec2i(e, 3));
    return vec4f(ldexp(m, e), v, ldexp(-0.75, i32(at.x) - 32) + ldexp(0.0, 5));
}
