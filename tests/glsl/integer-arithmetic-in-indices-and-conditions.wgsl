// Division, remainder and shifts that need care, inside indices, conditions, loop headers and arguments.

fn pick(i: i32) -> i32 {
    return i * 10;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 10;
    let y = i32(at.y);
    var list = array<i32, 5>(1, 2, 3, 4, 5);
    list[(x % 5 + 5) % 5] += y / (x | 1);
    var n = 0;
    for (var i = x / 3; i < y / 5 && n < 40; i += 1 << (u32(y) & 1u)) { n += pick(i % 3); }
    while x % 7 > n / 100 && n < 500 { n += 77; }
    if (x / 2) % 2 == -1 { n += 1000; }
    switch x % 4 { case -3: { n += 1; } case -1, 2: { n += 2; } default: { n += 3; } }
    return vec4i(list[0] + list[1] * 100, list[2] + list[3] * 100, n, list[4]);
}
