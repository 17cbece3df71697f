// pack4x8snorm and pack2x16snorm, and back.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let p = (floor(at.xy) - 30.0) / 25.0;
    let four = pack4x8snorm(vec4f(p, -p.y, 0.3));
    let two = pack2x16snorm(p.yx);
    let back = unpack4x8snorm(four ^ 0x80807F01u) + vec4f(unpack2x16snorm(two ^ 0x80000000u), 0.0, 1.0) + 4.0;
    return vec4u(four, two, vec2u(round(back.xy * 4096.0) + round(back.zw * 128.0)));
}
