// Sums, differences and products are taken modulo 2^32.

const EDGES = array<i32, 8>(1, -1, 46341, -65536, 2147483647, -2147483648, 305419896, 123456789);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let a = EDGES[i32(at.x) % 8];
    let b = EDGES[i32(at.y) % 8];
    let u = bitcast<u32>(a) * bitcast<u32>(b) + 4294967295u;
    let v = vec2i(a, b) * vec2i(b, 7) + vec2i(2147483647);
    return vec4i(a + b, a * b, a - b, bitcast<i32>(u) ^ v.x ^ (v.y * 31));
}
