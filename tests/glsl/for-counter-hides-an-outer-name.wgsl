// The counter hides a variable of the same name, which its own initialiser still reads, and which is back afterwards.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var i = i32(at.x);
    let y = i32(at.y);
    var sum = 0;
    for (var i = i + 1; i < 70; i++) {
        sum += i;
        let i = y;
        sum += i * 1000;
    }
    i += 1;
    for (var y = y; y < 64; y += 7) { i += y; }
    return vec4i(i, sum, y, 0);
}
