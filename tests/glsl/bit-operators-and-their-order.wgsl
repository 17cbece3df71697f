// `&`, `|`, `^`, `~`, shifts and arithmetic, in parentheses where WGSL wants them and bare where it does not.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let a = u32(at.x) * 0x9E3779B9u;
    let b = u32(at.y) * 0x85EBCA6Bu;
    let c = a ^ b ^ 0xFFu;
    let d = (a & 0xFFFFu) | (b & ~0xFFFFu);
    let e = (((a >> 3u) + (b << 2u)) * 5u) ^ (c);
    let f = (a + b * 3u - c / 5u % 7u) & (d | e);
    let v = (vec2u(a, b) ^ vec2u(b, 1u)) & vec2u(~c);
    let ok = ((a & 1u) == 1u && (b | 2u) != 3u) || -1 < 0;
    return vec4u(d, e, f, v.x + v.y + u32(ok) * ((1u << 31u) >> 1u));
}
