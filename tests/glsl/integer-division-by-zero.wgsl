// What cannot be divided is left as it is: by zero, and the least number by -1.

const EDGES = array<i32, 16>(0, 1, -1, 2, -2, 3, -7, 10, 31, -32, 1000, -65536, 16777217, 2147483647, -2147483647, -2147483648);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let a = EDGES[i32(at.x) % 16];
    let b = EDGES[i32(at.y) % 16];
    let u = bitcast<u32>(a) / bitcast<u32>(b);
    let v = vec2i(a, b) / vec2i(b, a);
    var c = a;
    c /= b;
    return vec4i(a / b, bitcast<i32>(u), v.y, c - 7 / b);
}
