// A `continue` in a switch goes on with the next turn of the loop around it, over the rest of the body.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var sum = 0;
    var skipped = 0;
    for (var i = 0; i < x; i++) {
        switch i % 4 {
            case 0: { skipped += 1; continue; }
            case 1: { if i > y { continue; } sum += 1; }
            case 2: { break; }
            default: {}
        }
        sum += 10;
    }
    var n = 0;
    var odd = 0;
    loop {
        switch n % 2 {
            case 1: { odd += 1; continue; }
            default: { if n >= y { break; } }
        }
        if n >= y { break; }
        sum += 3;
        continuing {
            n += 1;
        }
    }
    return vec4i(sum, skipped, n, odd);
}
