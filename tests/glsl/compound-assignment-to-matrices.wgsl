// Whole matrices, columns, and single elements by constant and variable index.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = i32(at.x);
    var m = mat3x2f(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    m *= 2.0;
    m += mat3x2f(1.0, 1.0, 1.0, 0.5, 0.5, 0.5);
    m -= mat3x2f(vec2f(1.0), vec2f(2.0), vec2f(3.0));
    m[0] += vec2f(0.25, at.y);
    m[x % 3] *= 2.0;
    m[1].y -= 3.0;
    m[x % 3][x & 1] += 8.0;
    m[2][1] /= 2.0;
    var s = mat2x2f(1.0, 2.0, 3.0, 4.0);
    s *= mat2x2f(0.0, 1.0, 1.0, 0.0);
    var v = m[x % 3];
    v *= s;
    return vec4f(v, m[0].y + m[1].y, m[2].x + m[2].y);
}
