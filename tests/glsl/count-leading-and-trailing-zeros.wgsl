// 32 of zero; of i32 and u32, scalars and vectors.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = u32(at.x);
    let u = (u32(at.y) * 0x01010101u) >> (x % 32u);
    let i = bitcast<i32>(u << (x / 2u));
    let v = countLeadingZeros(vec2u(u, x));
    let t = countTrailingZeros(vec3i(i, 0, i32(x)));
    return vec4i(
        i32(countLeadingZeros(u)) + 100 * countLeadingZeros(i),
        i32(countTrailingZeros(u)) + 100 * countTrailingZeros(i),
        i32(v.x + v.y * 100u),
        t.x + t.y * 100 + t.z * 10000,
    );
}
