// vec * mat against transpose(mat) * vec.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = vec3f(floor(at.xy), 2.0);
    let m = mat3x3f(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0);
    var v = p;
    v *= m;
    return vec4f(p * m - transpose(m) * p, v.x) + vec4f(v, dot(p * m, p));
}
