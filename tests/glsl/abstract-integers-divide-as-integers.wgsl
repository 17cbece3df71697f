// Whole numbers in constant expressions stay whole numbers until a float is wanted: `1 / 2` is zero.

const HALF = 1 / 2;
const THIRDS: f32 = 7 / 3;
const SHIFTED: f32 = 1 << 3u;
const REST = 7 % 4 * 1.5;

fn scaled(x: f32) -> f32 {
    return x * (7 / 2) + 1 / 2 + (5 % 3) * x;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    let a: f32 = 9 / 4;
    let b = x + HALF;
    let c = vec2f(5 / 2, 5 / 2.0);
    let d = max(x, 13 / 2);
    let e = x * (1.0 / 2) + (3 | 4);
    return vec4f(scaled(x), a + b + THIRDS + SHIFTED, c.x + c.y * 16.0 + REST, d + e);
}
