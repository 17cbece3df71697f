// `continuing` reads what the body declared, and declares names of its own.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var i = 0;
    var sum = 0;
    loop {
        let square = i * i;
        var twice = square * 2;
        if square > x { break; }
        twice += 1;
        continuing {
            let more = twice + square;
            sum += more;
            i += 1;
            if more > 50 { sum += 1000; }
        }
    }
    return vec4i(i, sum, 0, 0);
}
