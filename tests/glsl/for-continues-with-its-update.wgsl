// `continue` in a `for` still runs its update, also from two `if`s deep.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var sum = 0;
    var odd = 0;
    for (var i = 0; i < x; i++) {
        if i % 2 == 1 {
            odd += 1;
            if i > y { continue; }
            sum += 1000;
        }
        if i == 40 { continue; }
        sum += i;
    }
    return vec4i(sum, odd, 0, 0);
}
