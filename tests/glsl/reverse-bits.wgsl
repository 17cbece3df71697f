// The lowest bit becomes the highest.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let n = u32(at.x) * 0x9E3779B9u + u32(at.y);
    let i = reverseBits(bitcast<i32>(n));
    return vec4u(reverseBits(n), bitcast<u32>(i), reverseBits(vec2u(n, 1u)).y, reverseBits(vec3u(n, u32(at.x), 0u)).y);
}
