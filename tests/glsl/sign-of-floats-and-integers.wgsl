// -1, 0 or 1.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let i = i32(at.x) - 32;
    let f = f32(i) * 0.25;
    let v = sign(vec3f(f, -f, 0.0));
    let k = sign(vec3i(i, -i, i32(at.y) - 7));
    return vec4i(sign(i), i32(sign(f)), i32(v.x + v.y * 10.0 + v.z * 100.0), k.x + 10 * k.y + 100 * k.z);
}
