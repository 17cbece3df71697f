// `&`, `|`, `!`, `==` of vectors of booleans, `&` and `|` of single ones, which do not short-circuit.

var<private> calls: i32;

fn seen(b: bool) -> bool {
    calls += 1;
    return b;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    let a = vec3<bool>(x > 10, x > 20, y > 30);
    let b = vec3<bool>(y > 10, x < 40, y < 50);
    let c = (a & b) | !a;
    let d = !(a | b) == b;
    let one = (seen(x > y) & seen(x > 5)) | seen(y > 60);
    var e = one;
    e &= x < 60;
    e |= y == 0;
    return vec4i(dot(vec3i(c), vec3i(1, 2, 4)), dot(vec3i(d), vec3i(1, 2, 4)), i32(one) + 2 * i32(e) + 4 * i32(!e), calls);
}
