// Both values of a select are evaluated, from left to right, whichever is taken.

var<private> trace: i32;

fn note(n: i32) -> i32 {
    trace = trace * 10 + n;
    return n;
}

fn check(b: bool) -> bool {
    trace = trace * 10 + 9;
    return b;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let a = select(note(1), note(2), check(x > 20));
    let b = select(vec2i(note(3), x), vec2i(note(4)), vec2<bool>(x > 40, check(x < 50)));
    return vec4i(trace, a, b);
}
