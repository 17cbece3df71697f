// pack4x8snorm and pack2x16snorm, and back.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let p = (floor(at.xy) - 30.0) / 25.0;
    let four = pack4x8snorm(vec4f(p, -p.y, 0.3));
    let two = pack2x16snorm(p.yx);
    let a = vec4u(floor(unpack4x8snorm(four ^ 0x80807F01u) * 16.0 + 20.3));
    let b = vec2u(floor(unpack2x16snorm(two ^ 0x80000000u) * 16.0 + 20.35));
    return vec4u(four, two, a.x + a.y * 64u + a.z * 4096u + a.w * 262144u, b.x + b.y * 64u);
}
