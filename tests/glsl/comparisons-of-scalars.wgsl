// All six, of f32, i32 and u32; == and != of booleans.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 30;
    let y = i32(at.y) - 30;
    let f = f32(x) * 0.5;
    let g = f32(y) * 0.5;
    let u = bitcast<u32>(x);
    let w = bitcast<u32>(y);
    return vec4i(
        bits(x == y, x != y, x < y, x <= y) + 16 * bits(x > y, x >= y, x == 3, 4 < y),
        bits(f == g, f != g, f < g, f <= g) + 16 * bits(f > g, f >= g, f == 1.5, 2 < g),
        bits(u == w, u != w, u < w, u <= w) + 16 * bits(u > w, u >= w, u == 3, 4 < w),
        bits((x > 0) == (y > 0), (x > 0) != (y > 0), true == (x > 5), false),
    );
}

fn bits(a: bool, b: bool, c: bool, d: bool) -> i32 {
    return i32(a) | (i32(b) << 1u) | (i32(c) << 2u) | (i32(d) << 3u);
}
