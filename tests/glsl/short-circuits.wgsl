// The right side of `&&` and `||` is evaluated only where it counts.

var<private> trace: i32;

fn yes(n: i32) -> bool {
    trace = trace * 10 + n;
    return true;
}

fn no(n: i32) -> bool {
    trace = trace * 10 + n;
    return false;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let a = x > 20 && yes(1);
    let b = x > 40 || no(2) || yes(3);
    let c = (no(4) || x % 2 == 0) && (yes(5) && !no(6));
    var r = 0;
    if (a && b) || (c && yes(7)) { r = 1; }
    while x < 10 && no(8) { r = 2; }
    return vec4i(trace, i32(a) + 2 * i32(b) + 4 * i32(c), r, 0);
}
