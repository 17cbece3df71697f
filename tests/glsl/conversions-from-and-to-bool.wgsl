// true is 1; whatever is not zero is true.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 3;
    let f = floor(at.y) * 0.5 - 2.0;
    let b = bool(x);
    let c = bool(f);
    let v = vec3<bool>(vec3i(x, 0, 7));
    let w = vec2f(vec2<bool>(b, !c));
    let u = vec2u(vec2<bool>(vec2f(f, -0.0)));
    return vec4i(
        i32(b) + 10 * i32(u32(c)) + 100 * i32(bool(u32(x))),
        i32(f32(b)) + i32(bool(b)),
        i32(v.x) + 2 * i32(v.y) + 4 * i32(v.z),
        i32(w.x + 10.0 * w.y) + i32(u.x * 100u + u.y * 1000u),
    );
}
