// Inner and outer loop each with `continue`, `continuing` and `break if`.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) % 16;
    let y = i32(at.y) % 16;
    var i = 0;
    var sum = 0;
    var inner = 0;
    loop {
        var j = 0;
        loop {
            if j == y { break; }
            if (i + j) % 2 == 0 { continue; }
            sum += j;
            continuing {
                inner += 1;
                j += 1;
                break if j > 12;
            }
        }
        if i % 4 == 3 { continue; }
        sum += 100;
        continuing {
            i += 1;
            break if i > x;
        }
    }
    return vec4i(i, sum, inner, 0);
}
