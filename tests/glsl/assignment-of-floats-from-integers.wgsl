// Conversions at every place where GLSL would convert by itself, or not at all.

fn third(n: i32) -> f32 {
    return f32(n) / 3.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let n = i32(at.x);
    var v = vec3f(f32(n), 1, 2.0);
    v.y = f32(n / 2);
    v += vec3f(vec3i(1, n, 2));
    let u = u32(v.x) + u32(n);
    let m = mat2x2f(f32(n), 0, 0, f32(u));
    return vec4f(floor(third(n)), v.y + v.z, m[1].y, f32(i32(v.y) * 2) + f32(u32(1.5)));
}
