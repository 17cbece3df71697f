// A comment ends at each of WGSL's line breaks, and a backslash joins no lines. \
const A = 1.0; // vertical tab:const B = 2.0; // form feed:const C = 3.0; // next line:const D = 4.0;
// line separator: const E = 5.0; // paragraph separator: const F = 6.0; // carriage return:const G = 7.0;
/* a block with \
and   inside */ const H‎= 8.0;‏ // marks of direction are blank

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x); // \
    let y = x + 1.0; // ??/
    return vec4f(A + B + C + D, E + F + G + H, x, y);
}
