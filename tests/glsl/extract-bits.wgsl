// Any offset and count, also past the end, where what is left is taken; an i32 keeps its sign.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let offset = u32(at.x) % 36u;
    let count = u32(at.y) % 36u;
    let u = 0xA5C3F00Fu;
    let i = bitcast<i32>(u * (u32(at.x) | 1u));
    let v = extractBits(vec2u(u, u32(i)), offset, count);
    let w = extractBits(vec3i(i, -5, 100), 1u, 4u);
    return vec4i(bitcast<i32>(extractBits(u, offset, count)), extractBits(i, offset, count), bitcast<i32>(v.y), w.x + w.y * 100 + w.z * 10000);
}
