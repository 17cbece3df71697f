// Of matrices of every shape.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let a = transpose(mat2x3f(p.x, 1.0, 2.0, 3.0, p.y, 4.0));
    let b = transpose(mat4x2f(1.0, 2.0, p.x, 4.0, 5.0, p.y, 7.0, 8.0));
    let c = transpose(mat3x3f(1.0, p.x, 3.0, 4.0, 5.0, 6.0, p.y, 8.0, 9.0));
    return vec4f(a[2], b[1].xy + c[0].yz) + vec4f(a[0].y, a[1].x, b[0].w, c[2].x) * 100.0;
}
