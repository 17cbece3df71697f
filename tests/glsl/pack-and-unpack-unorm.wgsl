// pack4x8unorm and pack2x16unorm, and back.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let p = (floor(at.xy) % 24.0 - 4.0) / 17.0;
    let four = pack4x8unorm(vec4f(p, 1.5, 0.25));
    let two = pack2x16unorm(p.yx);
    let a = vec4u(floor(unpack4x8unorm(four * 3u) * 16.0 + 0.3));
    let b = vec2u(floor(unpack2x16unorm(two + 17u * u32(at.x)) * 16.0 + 0.35));
    return vec4u(four, two, a.x + a.y * 64u + a.z * 4096u + a.w * 262144u, b.x + b.y * 64u);
}
