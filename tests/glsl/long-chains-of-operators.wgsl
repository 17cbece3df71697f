// Deep and long expressions keep their order.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y) + 1;
    let a = ((((((x + 1) * 2 - 3) / y + 4) * 5 - 6) % 97 + 7) * 8 - 9) / 2;
    let b = x + y - x * y + x / y - x % y + (x & y) - (x | y) + (x ^ y);
    let c = x - (y - (x - (y - (x - (y - (x - y))))));
    let d = (x << 1u) + (y >> 1u) - ((x + y) << 2u) + (-x >> 3u);
    return vec4i(a, b, c, d);
}
