// Abstract floats have the precision and range of an f64 until they become an f32.

const TEN = 1e200 / 1e199;
const SMALL = 1e-60 * 1e59;
const NEAR = 16777217.0 - 16777216.0;
const EQUAL = 0.1 + 0.2 == 0.3;
const WIDE = 3000000000 * 2;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    let big: f32 = WIDE;
    return vec4f(x * TEN, x + SMALL * 100.0, NEAR + select(0.0, 10.0, EQUAL) + x, big + f32(4294967296) * x);
}
