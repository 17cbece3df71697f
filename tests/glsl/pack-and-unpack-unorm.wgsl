// pack4x8unorm and pack2x16unorm, and back.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let p = (floor(at.xy) - 8.0) / 40.0;
    let four = pack4x8unorm(vec4f(p, 1.5, 0.25));
    let two = pack2x16unorm(p.yx);
    let back = unpack4x8unorm(four * 3u) + vec4f(unpack2x16unorm(two + 17u), 0.0, 1.0);
    return vec4u(four, two, vec2u(round(back.xy * 16384.0) + round(back.zw * 128.0)));
}
