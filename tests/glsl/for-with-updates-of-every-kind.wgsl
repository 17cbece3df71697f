// A `for` counts by `++`, `--`, compound assignment, assignment, and a call; begins with an assignment or a call.

var<private> calls: i32 = 0;

fn tick(by: i32) {
    calls += by;
}

fn next(i: i32) -> i32 {
    return i * 2 + 1;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var r = vec4i();
    for (var i = x; i > 0; i--) { r.x += i; }
    for (var i: u32 = 0u; i < u32(x); i += 3u) { r.y += i32(i); }
    var k = 0;
    for (k = 1; k < x; k = next(k)) { r.z += k; }
    for (tick(2); calls < x; tick(5)) { r.w += calls; }
    for (var p = vec2i(0, x); p.x < p.y; p.x += 2) { r.w += 10000; }
    return r;
}
