// u32 values above 2^31, i32 values at both ends, and constants computed from them.

const TOP = 0x80000000u;
const ALL = 4294967295u;
const LEAST = -2147483648;
const MOST: i32 = 0x7FFFFFFF;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let x = u32(at.x);
    let i = select(LEAST, MOST, at.y > 30.0);
    let least: i32 = -2147483648;
    return vec4u(x + TOP, ALL - x, bitcast<u32>(i) ^ x, u32(least) + u32(i == LEAST) + (x ^ 0xDEADBEEF));
}
