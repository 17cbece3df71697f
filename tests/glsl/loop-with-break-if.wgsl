// `break if` ends the loop at the end of its `continuing` block.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var a = 0;
    loop {
        a += 5;
        continuing {
            break if a > x;
        }
    }
    var i = 0;
    var sum = 0;
    loop {
        if i % 2 == 0 { continue; }
        sum += i;
        continuing {
            i++;
            break if i > y || sum > 100;
        }
    }
    return vec4i(a, i, sum, 0);
}
