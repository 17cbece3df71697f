// What is in parentheses is done first, even where it would not matter without rounding.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x) + 1.0;
    let y = floor(at.y) + 1.0;
    return vec4f(x - (y - 2.0), x / (y * 0.5) * 0.0 + x * (y + 3.0), x - (y + 4.0) - (x - 8.0), -(x + y) * -(x - y));
}
