// The sign is the dividend's; by zero, and of the least number by -1, the remainder is zero.

const EDGES = array<i32, 16>(0, 1, -1, 2, -2, 3, -7, 10, 31, -32, 1000, -65536, 16777217, 2147483647, -2147483647, -2147483648);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let a = EDGES[i32(at.x) % 16];
    let b = EDGES[i32(at.y) % 16];
    let u = bitcast<u32>(a) % bitcast<u32>(b);
    let v = vec3i(a, b, -13) % vec3i(b, a, 5);
    var c = a;
    c %= b;
    return vec4i(a % b, bitcast<i32>(u), v.y + v.z, c + (a % 7) * 3);
}
