// Products of matrices that are not square, sums, differences, and products with numbers.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let a = mat2x3f(p.x, 2.0, 3.0, 4.0, p.y, 6.0);
    let b = mat3x2f(1.0, p.y, 0.0, 2.0, p.x, 1.0);
    let c = a * b;
    let d = b * a;
    let e = (c + c * 2.0 - 0.5 * c);
    let f = mat4x4f(vec4f(d[0], d[1]), vec4f(d[1], d[0]), vec4f(d[0], d[0]), vec4f(p, p));
    let g = f * f - f;
    let h = c * 0.5 + transpose(c);
    return vec4f(c[2].y + d[1].x, e[0].x + e[1].z, g[3].w, h[1].x);
}
