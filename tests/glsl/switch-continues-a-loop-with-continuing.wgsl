// `continue` in a switch, where the loop's `continuing` block does work of its own and ends with `break if`.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var i = 0;
    var a = 0;
    var b = 0;
    loop {
        switch i % 5 {
            case 0: { a += 1; continue; }
            case 1, 2: {
                if (i + y) % 3 == 0 { continue; }
                a += 10;
            }
            case 3: { a += 100; break; }
            default: { continue; }
        }
        a += 1000;
        continuing {
            b += i;
            i += 1;
            break if i > x;
        }
    }
    return vec4i(a, b, i, 0);
}
