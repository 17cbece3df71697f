// A switch in a case of a switch; each `break` leaves the inner one.

fn nested(x: i32, y: i32) -> i32 {
    var r = 0;
    switch x % 3 {
        case 0: {
            switch y % 3 {
                case 0: { r = 1; break; }
                case 1: { r = 2; }
                default: { if y > 30 { break; } r = 3; }
            }
            r += 10;
        }
        case 1: {
            for (var i = 0; i < y; i++) {
                switch i {
                    case 7: { r += 70; continue; }
                    case 9: { r += 90; break; }
                    default: { r += 1; }
                }
                r += 2;
            }
        }
        default: { r = -1; }
    }
    return r;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    return vec4i(nested(x, y), nested(y, x), nested(x + 1, y), nested(x + 2, y));
}
