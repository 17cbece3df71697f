// Calls with side effects in one expression, in arguments, constructors, operators and indices.

var<private> trace: i32;

fn note(n: i32) -> i32 {
    trace = trace * 7 + n;
    return n;
}

fn three(a: i32, b: i32, c: i32) -> i32 {
    return a + b * 10 + c * 100;
}

fn bump(p: ptr<function, i32>) -> i32 {
    *p += 1;
    return *p;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) % 5;
    let a = note(1) + note(2) * note(3) - note(x);
    let b = three(note(4), note(5), note(6));
    let v = vec3i(note(2), note(1), note(3));
    let l = array<i32, 3>(note(1), note(x), note(5))[note(2) % 3];
    var n = x;
    let c = bump(&n) * 100 + bump(&n) * 10 + bump(&n);
    return vec4i(trace, a * 1000 + b, v.x + v.y * 10 + l * 100, c);
}
