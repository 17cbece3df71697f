// Hexadecimal, hexadecimal floats, exponents, suffixes, leading and trailing points, and the greatest ones.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = 0xFF + 0X1f + 0;
    let b = 1e3 + 1.5E-2 + 2.e+1 + .25 + 0.5f + 3f + 1e1f;
    let c = 0x1.8p3 + 0x.8p1 + 0x10p-2f + 0XA.P+1;
    let d = 4294967295u;
    let e = -2147483647i;
    let f = 0xFFFFFFFFu - 0x7fu;
    let g = 1.17549435e-38 * 3.40282347e+38;
    let h = 2147483647 - 7i;
    let x = floor(at.x) * 00.5;
    return vec4f(f32(a) + b + x, c, f32(d / 65536u) + f32(e / 65536), f32(f >> 16u) + g + f32(h >> 8u));
}
