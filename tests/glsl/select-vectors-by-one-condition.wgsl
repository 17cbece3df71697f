// A vector of any type is chosen whole.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    let f = select(vec2f(1.5, 2.5), vec2f(f32(x)), x > y);
    let u = select(vec4u(1u, 2u, 3u, 4u), vec4u(u32(y)), x % 3 == 0);
    let b = select(vec2<bool>(true, false), vec2<bool>(x > 5, y > 5), x + y > 20);
    return vec4i(i32(f.x * 2.0), i32(f.y * 2.0), i32(u.z + u.w), i32(b.x) + i32(b.y) * 2);
}
