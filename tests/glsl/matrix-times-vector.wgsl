// Every shape by its vector, from the left and from the right.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let a = mat2x3f(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    let b = mat4x2f(p, vec2f(1.0, 2.0), vec2f(3.0, 4.0), vec2f(5.0, 6.0));
    let c = mat3x3f(p.x, 0.0, 1.0, 0.0, p.y, 0.0, 2.0, 0.0, 3.0);
    let d = a * p;
    let e = vec3f(p, 1.0) * a;
    let f = b * vec4f(p, 1.0, 2.0);
    let g = p * b;
    let h = c * vec3f(1.0, 2.0, 3.0) - vec3f(1.0, 2.0, 3.0) * c;
    return vec4f(d.x + d.y + d.z, e.x + e.y * 4.0, f.x + f.y + g.z + g.w, h.x + h.y + h.z);
}
