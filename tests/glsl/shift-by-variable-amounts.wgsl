// Only the low five bits of the amount count; an i32 is filled with its sign, a u32 with zeros.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let u = 0x80F00F01u ^ u32(at.x);
    let i = bitcast<i32>(u);
    let n = u32(at.y);
    let v = vec2i(i, 1) << vec2u(n, n + 1u);
    let w = vec2u(u, 0xFFFFFFFFu) >> vec2u(n, 31u - n);
    return vec4i(i << n, i >> n, bitcast<i32>((u << n) ^ (u >> n)), v.y ^ bitcast<i32>(w.y) ^ (v.x + bitcast<i32>(w.x)));
}
