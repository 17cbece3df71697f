// `let` without a type gets the one of its value.

struct S { v: vec3f, n: i32 }

fn make(x: f32) -> S {
    return S(vec3f(x), i32(x));
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = floor(at.x);
    let b = i32(a);
    let c = u32(b);
    let d = a > 3.0;
    let e = at.xy;
    let f = vec3i(b);
    let g = e > vec2f(5.0);
    let h = mat2x2f(e, e);
    let i = array(a, 2.0, 3.0);
    let j = make(a);
    let k = j.v.xy;
    let l = h * floor(e);
    let m = 5;
    let n = 5.5;
    let o = vec2(1, 2);
    let p = ~c;
    let q = !d;
    let r = array(j, j);
    return vec4f(
        f32(f.x + m + o.y) + n + f32(p & 0xFFu),
        f32(d) + f32(g.x) + f32(q) * 10.0,
        i[b % 3] + k.y + f32(j.n) + r[1].v.z,
        l.x,
    );
}
