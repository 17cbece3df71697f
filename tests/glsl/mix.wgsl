// Blends by a number, by a vector, and a vector by a number.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let t = floor(at.x) / 64.0;
    let s = floor(at.y) / 8.0;
    let v = mix(vec3f(0.0, 8.0, 16.0), vec3f(64.0, 4.0, 0.0), t);
    let w = mix(vec2f(1.0, 2.0), vec2f(3.0, 4.0), vec2f(t, s));
    return vec4f(mix(1.0, 2.0, t), v.x + v.y, v.z, w.x + w.y * 128.0);
}
