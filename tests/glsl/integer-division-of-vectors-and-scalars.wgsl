// A vector by a number and a number by a vector, in i32 and u32.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let v = vec3i(vec2i(at.xy) - 20, -77);
    let n = i32(at.x) % 5;
    let a = v / n;
    let b = 1000 / v;
    let c = v % n;
    let u = (vec2u(at.xy) + 7u) / vec2u(3u, u32(at.x) / 40u) + 100u % vec2u(at.yx);
    return vec4i(a.x + b.y * 100, b.x + c.z * 10000, c.x + a.z * 100, i32(u.x + u.y * 100u));
}
