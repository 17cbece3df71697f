// Of vectors of booleans, and of single ones.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    let v = vec3<bool>(x > 10, y > 20, x > y);
    return vec4i(
        i32(any(v)) + 2 * i32(all(v)),
        i32(all(vec2i(x, y) > vec2i(5, 50))),
        i32(any(vec4i(x, y, x, y) == vec4i(1, 2, 3, 4))),
        i32(any(x > 30)) + 2 * i32(all(y > 30)),
    );
}
