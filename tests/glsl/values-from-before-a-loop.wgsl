// `let` values taken before a loop stay what they were while the variables go on.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var n = i32(at.x);
    let start = n;
    var last = n;
    var list = array<i32, 2>(n, 5);
    let kept = list;
    let first = list[0];
    for (var i = 0; i < 4; i++) {
        let before = n;
        n += i * 2;
        list[0] += before;
        last = before;
    }
    return vec4i(start + n * 100, last, kept[0] + list[0] * 100, first);
}
