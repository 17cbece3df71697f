// `while` with and without parentheses, left by `break`, gone on with by `continue`.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var a = x;
    var b = y;
    while b != 0 {
        let t = a % b;
        a = b;
        b = t;
    }
    var n = 0;
    var sum = 0;
    while (n < x) {
        n++;
        if n % 4 == 0 { continue; }
        if sum > 300 { break; }
        sum += n;
    }
    while false { sum = -1; }
    while n > 0 && sum > y { n -= 1; sum -= 2; }
    return vec4i(a, n, sum, b);
}
