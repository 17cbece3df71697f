// +, -, *, / of a vector with a number on either side.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let v = vec3f(floor(at.xy), 4.0);
    let s = floor(at.x) + 1.0;
    let a = v + 1 - (2.0 - v) * 0.5;
    let b = 3 * v / 4;
    let i = (vec2i(at.xy) + 5) * 2 - 1;
    let u = 100u - vec2u(at.xy) * 1u;
    return vec4f(a.x + b.y * 64.0, a.z + s, f32(i.x + i.y * 256), f32(u.y)) + vec4f(2.0) * v.zzzx;
}
