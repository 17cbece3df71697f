// From scalars, vectors, one number for all, and inferred types.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let a = vec3(p.x);
    let b = vec4(p, p);
    let c = vec4(1.0, p, 2.0);
    let d = vec2<i32>();
    let e = vec3u(1u, vec2u(p));
    let f = vec4(vec3(p, 1), 5);
    let g = vec2(3);
    let h = vec3<bool>(true);
    let i = vec3f(vec3i(g, 4));
    return vec4f(a.z + b.w, c.y + f32(d.x) + f.w, f32(e.z) + f32(h.z), i.z + i.x + c.w);
}
