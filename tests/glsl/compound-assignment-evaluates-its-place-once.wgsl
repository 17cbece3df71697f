// The place on the left is worked out once, side effects and all.

var<private> calls: i32 = 0;

fn next() -> i32 {
    calls += 1;
    return calls % 4;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var a = array<i32, 4>(x, 20, 30, 40);
    a[next()] += 1;
    a[next()]++;
    a[next()] *= 2;
    var v = vec4i(0, 1, 2, 3);
    v[next()] -= x;
    var rows = array<array<i32, 4>, 4>();
    rows[next()][next()] += 7;
    return vec4i(a[0] + a[1] * 1000, a[2] + a[3] * 1000, v.x + rows[1][2] * 1000, calls);
}
