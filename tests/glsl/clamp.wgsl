// Of f32, i32 and u32, scalars and vectors; for integers the upper bound wins over a greater lower one.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 32;
    let y = i32(at.y) - 32;
    let f = clamp(f32(x) * 0.5, -3.0, 7.25) + clamp(vec2f(f32(x), f32(y)), vec2f(0.0), vec2f(9.0, 3.0)).y;
    let u = clamp(bitcast<u32>(x), 2u, 40u);
    let k = clamp(vec2i(x, y), vec2i(-3), vec2i(3, 20));
    return vec4i(clamp(x, -5, y), i32(f * 4.0), bitcast<i32>(u) * 100 + clamp(x, y + 10, -10), k.x + k.y * 100);
}
