// A `break` in a switch inside a loop leaves the switch; the loop goes on.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var sum = 0;
    var turns = 0;
    for (var i = 0; i < x; i++) {
        switch i % 3 {
            case 0: { sum += i; break; }
            case 1: {
                if i > y { break; }
                sum += 100;
            }
            default: { sum -= 1; }
        }
        turns += 1;
    }
    var left = x;
    loop {
        if left <= 0 { break; }
        switch left & 3 {
            case 1, 3: { left -= 1; }
            default: { left -= 2; break; }
        }
        turns += 1000;
    }
    return vec4i(sum, turns, left, 0);
}
