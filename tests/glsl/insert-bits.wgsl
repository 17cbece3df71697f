// The low bits of the second go over those of the first from an offset on, a count of them, never past the end.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let offset = u32(at.x) % 36u;
    let count = u32(at.y) % 36u;
    let u = 0xA5C3F00Fu;
    let fresh = 0x12345678u ^ u32(at.y);
    let i = insertBits(bitcast<i32>(u), bitcast<i32>(fresh), offset, count);
    let v = insertBits(vec2u(u, 0u), vec2u(fresh, ~0u), offset, count);
    let w = insertBits(vec3i(-1, 0, 5), vec3i(0, i, 7), 3u, 9u);
    return vec4i(bitcast<i32>(insertBits(u, fresh, offset, count)), i, bitcast<i32>(v.y), w.x ^ w.y ^ w.z);
}
