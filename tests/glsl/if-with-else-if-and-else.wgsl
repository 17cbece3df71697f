// Each branch of a chain is taken somewhere on the grid, also where there is no last `else`.

fn chain(x: i32) -> i32 {
    if x < 10 {
        return 1;
    } else if x < 20 {
        return x * 2;
    } else if (x < 30) {
        return x * 3;
    } else {
        return -x;
    }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var found = 0;
    if x == y {
        found = 1;
    } else if x > y && x - y > 8 {
        found = 2;
    }
    var other = 100;
    if (x & 1) == 1 { other += 1; } else { other -= 1; }
    if !(y > 32) { other *= 2; }
    return vec4i(chain(x), chain(y), found, other);
}
