// pack2x16float of numbers that a half can hold, and back.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let p = (floor(at.xy) - 30.0) * vec2f(0.125, 64.0);
    let two = pack2x16float(p);
    let back = unpack2x16float(two + 0x00010001u);
    return vec4u(two, bitcast<vec2u>(back), bitcast<u32>(unpack2x16float(0x3C00C500u).x));
}
