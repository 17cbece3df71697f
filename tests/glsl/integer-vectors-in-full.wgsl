// Arithmetic, bits and shifts of vectors of integers, also with single numbers on one side.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let p = vec2i(at.xy) - 20;
    let q = vec2u(at.xy);
    let a = (p & vec2i(0xF)) | (p ^ vec2i(3, 5));
    let b = ~p + -p * 3;
    let c = (q << vec2u(1u, 3u)) >> vec2u(2u);
    let d = (p >> vec2u(1u)) << (q % 5);
    var e = p;
    e <<= vec2u(1u, 2u);
    e ^= vec2i(1);
    e += 3;
    e *= vec2i(2, -1);
    return vec4i(a.x + a.y * 1000, b.x + b.y * 1000, i32(c.x + c.y * 1000u), d.x + d.y * 1000 + e.x + e.y);
}
