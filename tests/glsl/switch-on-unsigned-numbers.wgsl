// The selector is a u32, its cases with and without suffix, in hex, and up to the greatest.

fn code(x: u32) -> u32 {
    switch x {
        case 0u: { return 1u; }
        case 1, 2: { return 2u; }
        case 0x10u: { return 3u; }
        case 0xFFFFFFFFu: { return 4u; }
        case 2147483648: { return 5u; }
        default: { return x ^ 0xFFu; }
    }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let x = u32(at.x);
    return vec4u(code(x), code(x - 1u), code(x << 31u), code(~u32(at.y)));
}
