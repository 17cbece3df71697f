// `var` without an initialiser is zero, each time that it comes into being, in loops too.

struct Inner { k: vec2u, flag: bool }
struct Outer { inner: Inner, list: array<f32, 3>, turn: mat2x2f }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var total = vec4f();
    for (var i = 0; i < 3; i++) {
        var f: f32;
        var v: vec3f;
        var n: i32;
        var b: bool;
        var a: array<i32, 4>;
        var o: Outer;
        var m: mat3x3f;
        f += at.x;
        v.y += at.y;
        n += i;
        a[i] += n + 1;
        o.list[i] += 2.0;
        if o.inner.flag || b { total.x += 1000.0; }
        b = true;
        o.inner.flag = true;
        m[1].x += 1.0;
        o.inner.k.x += 1u;
        total += vec4f(f, v.y, f32(a[0] + a[1] + a[2]), o.list[i] + m[1].x + f32(o.inner.k.x) + o.turn[1].y);
    }
    return total;
}
