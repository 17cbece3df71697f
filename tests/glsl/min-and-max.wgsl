// Of f32, i32 and u32, scalars and vectors.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 32;
    let y = i32(at.y) - 32;
    let f = min(f32(x), f32(y)) + max(f32(x), 0.5) * 2.0;
    let v = max(min(vec2f(f32(x), f32(y)), vec2f(3.0)), vec2f(-4.0));
    let u = max(bitcast<u32>(x), 5u) - min(bitcast<u32>(y), 9u);
    let k = min(vec3i(x, y, 1), vec3i(y, 2, x)) + max(vec3i(x), vec3i(0, y, -5));
    return vec4i(min(x, y) * 100 + max(x, -y), i32((f + v.x + v.y) * 2.0), bitcast<i32>(u), k.x + k.y * 100 + k.z * 10000);
}
