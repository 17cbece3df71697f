// A `for`, a `switch` and a block inside `continuing`.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var i = 0;
    var a = 0;
    var b = 0;
    loop {
        if i > 9 { break; }
        if (i ^ x) % 3 == 0 { continue; }
        a += 1;
        continuing {
            for (var k = 0; k < 3; k++) {
                if k == y % 3 { continue; }
                b += k;
            }
            switch i % 3 {
                case 0: { b += 10; break; }
                case 1: { b += 100; }
                default: {}
            }
            { let i = b; b = i + 1; }
            i += 1;
        }
    }
    return vec4i(a, b, i, 0);
}
