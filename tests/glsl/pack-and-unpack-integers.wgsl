// pack4xI8, pack4xU8, their clamping kin, and back: bytes in one u32.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let i = vec4i(vec2i(at.xy) * 9 - 250, 300, -1);
    let u = vec4u(vec2u(at.xy) * 9u, 300u, 1u);
    let packed = vec4u(pack4xI8(i), pack4xU8(u), pack4xI8Clamp(i), pack4xU8Clamp(u));
    let signed = bitcast<vec4u>(unpack4xI8(packed.x));
    let plain = unpack4xU8(packed.y ^ packed.x);
    return packed ^ (signed << vec4u(1u)) ^ (plain * vec4u(65537u));
}
