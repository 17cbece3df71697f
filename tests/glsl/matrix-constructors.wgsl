// From columns, from numbers, of zeros, from another matrix.

alias Turn = mat2x2<f32>;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let a = mat2x2f(p, vec2f(3.0, 4.0));
    let b = mat3x3(vec3f(p, 1.0), vec3f(2.0), vec3f(p.y, 5.0, 6.0));
    let c = mat4x3<f32>(p.x, 1.0, 2.0, 3.0, p.y, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0);
    let d = mat2x4f();
    let e = Turn(a);
    let f = mat2x3(1, 2, 3, 4.5, 5, 6);
    let g = mat3x2<f32>(vec2f(1), p, vec2f(2, 3));
    let h = Turn(1.0, p.x, 0.0, 1.0);
    return vec4f(
        a[0].x + a[1].y + e[0].y,
        b[0].z + b[1].x + b[2].x * 100.0,
        c[0].x + c[1].y * 100.0 + c[3].z + d[1].w,
        f[1].x + g[1].y + h[0].y * 100.0,
    );
}
