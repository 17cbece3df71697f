// `<` and `>` as operators and as brackets in one line.

fn f(a: i32, b: i32) -> i32 {
    let c = array<i32, (4 >> 2u)>(a)[0];
    return c;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    let v = vec2<i32>(x, y);
    let less = (x < y) && y > (x >> 1u);
    let b = vec2<bool>(x<y, (y>x));
    let w = array<vec2<i32>, 2>(v, v.yx)[u32(x)>>5u];
    return vec4i(i32(less), i32(b.x) + i32(b.y) * 2, w);
}
