// The second value where the condition holds; both are evaluated.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    let f = select(1.5, f32(x), x > y);
    let u = select(7u, u32(y), (x & 1) == 0);
    let b = select(x > 3, y > 3, x == y || y > 50);
    let v = select(vec3i(x), vec3i(y, 1, 2), x < 20);
    return vec4i(select(-1, x, b), i32(f * 2.0), i32(u), v.x + v.y * 100 + v.z * 10000);
}
