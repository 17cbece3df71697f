// Reading columns and elements by an index that is not known when compiling, of variables and of values.

fn make(p: vec2f) -> mat3x4f {
    return mat3x4f(vec4f(p, 1.0, 2.0), vec4f(p.yx, 3.0, 4.0), vec4f(5.0, 6.0, p));
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let i = i32(at.x) % 3;
    let j = u32(at.y) % 4u;
    let m = make(floor(at.xy));
    var n = m;
    n[i][j] = 100.0;
    n[2 - i] = n[2 - i] + m[i];
    return vec4f(m[i][j], n[i][3], make(at.yx)[i].z, n[2][j]);
}
