// The place of the highest 1, for negative numbers of the highest 0; -1 where there is none.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = u32(at.x);
    let u = (u32(at.y) * 0x04030201u) >> (x % 32u);
    let i = bitcast<i32>(u << (x / 2u)) * (1 - 2 * i32(x & 1u));
    let v = firstLeadingBit(vec2u(u, x));
    let w = firstLeadingBit(vec4i(i, 0, -1, -i32(x)));
    return vec4i(bitcast<i32>(firstLeadingBit(u)), firstLeadingBit(i), bitcast<i32>(v.x + v.y * 100u), w.x + w.y * 100 + w.z * 1000 + w.w * 10000);
}
