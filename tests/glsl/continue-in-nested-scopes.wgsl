// `continue` and `break` from deep inside blocks, with locals that hide the loop's own.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var sum = 0;
    var n = 0;
    for (var i = 0; i < 30; i++) {
        let n0 = n;
        {
            let i = i * 2;
            if i > x {
                { if i % 3 == 0 { continue; } }
                { let x = i; if x > 50 { break; } }
            }
            sum += i;
        }
        loop {
            n += 1;
            if n % 3 == 0 { break; }
            if n > n0 + 1 { break; }
        }
        sum += n - n0;
    }
    return vec4i(sum, n, 0, 0);
}
