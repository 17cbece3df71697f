// What is assigned to `_` is evaluated and dropped.

var<private> calls: i32 = 0;

fn count() -> i32 {
    calls += 1;
    return calls;
}

struct Pair { a: i32, b: vec2f }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    _ = count();
    _ = x + count() * 2;
    _ = vec3f(at.xy, f32(count()));
    _ = Pair(count(), at.xy);
    _ = array<i32, 2>(x, count());
    _ = at;
    if x > 10 { _ = count(); }
    return vec4i(calls, x, 0, 0);
}
