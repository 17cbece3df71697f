// Conditions from constants, variables, calls, comparisons of booleans, and negations.

const ON = true;
const OFF = !ON;

fn even(x: i32) -> bool {
    return (x & 1) == 0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var r = vec4i();
    if ON { r.x += 1; }
    if OFF { r.x += 2; } else if even(x) { r.x += 4; }
    if !even(y) == even(x) { r.y = 1; }
    if (even(x)) != (even(y) || OFF) { r.y += 2; }
    let far = x > 32;
    if far { r.z = 3; }
    if !(far) && !(!even(x)) { r.z = 5; }
    if all(vec2i(x, y) < vec2i(20)) || any(vec2i(x, y) == vec2i(40)) { r.w = 9; }
    if vec2<bool>(far, even(y)).y { r.w += 10; }
    return r;
}
