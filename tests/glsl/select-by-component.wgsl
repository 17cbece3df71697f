// A vector of conditions chooses component by component, in vectors of floats, integers and booleans.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    let c = vec3<bool>(x > y, x % 2 == 0, y > 10);
    let f = select(vec3f(1.0, 2.0, 3.0), vec3f(f32(x), f32(y), 0.5), c);
    let i = select(vec3i(x), vec3i(-1, -2, -3), c);
    let u = select(vec2u(1u, 2u), vec2u(u32(x), u32(y)), c.xy);
    let b = select(vec3<bool>(true), vec3<bool>(x > 30), c);
    let kept = select(f, f.zxy, c.zyx);
    return vec4i(
        i32(f.x * 2.0 + f.y * 200.0 + f.z * 20000.0),
        i.x + i.y * 100 + i.z * 10000,
        i32(u.x + u.y * 100u) + 100000 * (i32(b.x) + i32(b.y) * 2 + i32(b.z) * 4),
        i32(kept.x * 2.0 + kept.y * 200.0 + kept.z * 20000.0),
    );
}
