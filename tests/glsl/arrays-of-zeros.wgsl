// `array<T, n>()` of numbers, vectors, booleans, matrices and structures.

struct Cell { v: vec2f, n: i32 }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var a = array<f32, 3>();
    var b = array<vec3f, 2>();
    var c = array<bool, 2>();
    var d = array<mat2x2f, 2>();
    var e = array<Cell, 2>();
    let i = i32(at.x) & 1;
    a[i] += 1.0;
    b[i].y += 2.0;
    c[i] = true;
    d[i][1] += vec2f(3.0);
    e[i].n += 4;
    return vec4f(a[0] + b[0].y, f32(c[1]) + d[0][1].x, f32(e[1].n) + e[0].v.x, a[2]);
}
