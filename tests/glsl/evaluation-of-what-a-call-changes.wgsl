// A variable that a call in the same expression changes: read before it counts as it was before.

var<private> state: i32;

fn push(n: i32) -> i32 {
    state += n;
    return state;
}

fn put(p: ptr<function, i32>, n: i32) -> i32 {
    *p = n;
    return n * 2;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    state = i32(at.x);
    let a = state * 100 + push(5);
    let b = push(1) + state;
    var n = i32(at.y);
    let c = n * 1000 + put(&n, 7);
    let d = vec3i(n, put(&n, 9), n);
    var list = array<i32, 2>(1, 2);
    list[push(0) & 1] = state + push(2);
    return vec4i(a, b, c, d.x + d.y * 10 + d.z * 100 + list[0] + list[1] * 1000);
}
