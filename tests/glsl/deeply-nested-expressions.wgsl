// Fifty parentheses deep, and forty terms long.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let a = (((((((((((((((((((((((((((((((((((((((((((((((((x + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) * 2) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) * 3) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) - 9) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) + 1) ^ 7) + 1) + 1) + 1) + 1) + 1);
    let b = x + 1 + x + 2 + x + 3 + x + 4 + x + 5 + x + 6 + x + 7 + x + 8 + x + 9 + x + 10 - x - 1 - x - 2 - x - 3 - x - 4 - x - 5 * x * 2 * x * 3;
    let c = max(max(max(max(max(max(max(max(x, 1), 2), 3), 4), 5), 6), 7), min(min(min(min(x, 90), 80), 70), 60));
    return vec4i(a, b, c, 0);
}
