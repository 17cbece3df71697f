// The plain loop, left from the middle.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var n = x + 1;
    var steps = 0;
    loop {
        if n == 1 || steps > 200 { break; }
        if n % 2 == 0 {
            n /= 2;
        } else {
            n = 3 * n + 1;
        }
        steps += 1;
    }
    var k = 0;
    loop { k += 3; if k > i32(at.y) { break; } }
    return vec4i(n, steps, k, 0);
}
