// Built, compared, selected from, indexed, passed, returned, in structures and arrays.

struct Flags { a: vec3<bool>, b: array<vec2<bool>, 2> }

fn flip(v: vec3<bool>) -> vec3<bool> {
    return !v.zyx;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var flags = Flags(vec3<bool>(x > 9, y > 9, x > y), array<vec2<bool>, 2>(vec2<bool>(true), vec2<bool>(x > 30, false)));
    flags.a = flip(flags.a);
    flags.a.x = !flags.a.y;
    flags.b[x & 1].y = flags.a[y % 3];
    let v = select(flags.a, vec3<bool>(flags.b[1], true), flags.a.yzx);
    let w = flags.a != v;
    return vec4i(dot(vec3i(flags.a), vec3i(1, 2, 4)), dot(vec3i(v), vec3i(1, 2, 4)), i32(any(w)), i32(flags.b[0].y) + 2 * i32(all(flags.b[1])));
}
