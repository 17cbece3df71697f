// Locals called like WGSL's own types and functions; what they hide is still there in other functions.

fn low(f32: vec2f) -> vec2f {
    let min = f32.x;
    let vec2f = f32.y;
    return f32 + min + vec2f;
}

fn high(a: vec2f) -> f32 {
    return min(a.x, a.y) + f32(3);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = low(floor(at.xy));
    let i32 = 2.0;
    let bool = p.x > 4.0;
    let array = select(i32, 7.0, bool);
    return vec4f(p, high(p), array);
}
