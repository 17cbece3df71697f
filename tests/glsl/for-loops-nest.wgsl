// `break` and `continue` in nested loops act on the nearest one.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var sum = 0;
    var pairs = 0;
    for (var i = 0; i < 12; i++) {
        for (var j = i; j < 12; j++) {
            if i * j > x { break; }
            if (i + j) % 5 == y % 5 { continue; }
            sum += i * 100 + j;
            for (var k = 0; k < 3; k++) {
                if k == j % 3 { break; }
                pairs += 1;
            }
        }
        if i > y { break; }
    }
    return vec4i(sum, pairs, 0, 0);
}
