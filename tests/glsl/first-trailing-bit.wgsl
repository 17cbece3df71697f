// The place of the lowest 1; -1 of zero.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = u32(at.x);
    let u = (u32(at.y) * 0x40302010u) << (x % 32u);
    let i = bitcast<i32>(u >> (x / 2u));
    let v = firstTrailingBit(vec2u(u, x));
    let w = firstTrailingBit(vec3i(i, 0, i32(x)));
    return vec4i(bitcast<i32>(firstTrailingBit(u)), firstTrailingBit(i), bitcast<i32>(v.x + v.y * 100u), w.x + w.y * 100 + w.z * 1000);
}
