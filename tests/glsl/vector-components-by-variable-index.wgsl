// Reading and writing `v[i]` of variables, values, and results of calls.

fn made(p: vec2f) -> vec3f {
    return vec3f(p, 7.0);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let i = i32(at.x) % 3;
    let j = u32(at.y) % 2u;
    let v = vec3f(floor(at.xy), 9.0);
    var w = vec4i(1, 2, 3, 4);
    w[i] = 50;
    w[j + 2u] += 7;
    var b = vec3<bool>(false);
    b[i] = true;
    return vec4f(v[i], made(at.yx)[i], f32(w[0] + w[1] * 100 + w[2] + w[3] * 100), f32(b.x) + 2.0 * f32(b[1]) + v.xy[j]);
}
