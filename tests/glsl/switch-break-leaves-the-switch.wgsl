// `break` in an `if` of a case goes on after the switch, and nothing falls through.

fn walk(x: i32, y: i32) -> i32 {
    var r = 1;
    switch x % 4 {
        case 0: {
            if y > 10 { break; }
            r += 100;
        }
        case 1: {
            r += 200;
            if y > 40 {
                r += 5;
                break;
            }
            r += 300;
        }
        case 2: { break; }
        default: {
            r = -r;
        }
    }
    return r * 2;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    return vec4i(walk(x, y), walk(y, x), walk(x + 1, y), walk(x + 2, y));
}
