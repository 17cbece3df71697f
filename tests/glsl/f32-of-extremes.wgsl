// The greatest and smallest normal numbers, written out and computed.

const GREATEST = 3.4028234663852886e38;
const SMALLEST = 1.1754943508222875e-38f;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x) + 1.0;
    return vec4f(GREATEST / x, SMALLEST * x, 1e-30 * x * 1e30, 16777216.0 + x * 2.0);
}
