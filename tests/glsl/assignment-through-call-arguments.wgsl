// Pointers to the same variable in one expression after another, and to parts of it.

struct Walk { at: vec2i, left: i32 }

fn step(walk: ptr<function, Walk>, by: vec2i) -> bool {
    (*walk).at += by;
    (*walk).left -= 1;
    return (*walk).left > 0;
}

fn half(n: ptr<function, i32>) -> i32 {
    *n /= 2;
    return *n;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var walk = Walk(vec2i(), i32(at.x) % 6);
    while step(&walk, vec2i(1, 2)) {}
    var n = i32(at.y);
    let sum = half(&n) + half(&n) * 100 + half(&walk.left) * 0;
    if step(&walk, vec2i(10, 0)) || step(&walk, vec2i(20, 0)) { n += 50; }
    return vec4i(walk.at, walk.left, sum + n * 10000);
}
