// The sign is the dividend's, unlike that of GLSL's mod; of scalars, vectors, and one by the other.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = (floor(at.x) - 32.0) * 0.5;
    let b = select(floor(at.y) - 32.5, 0.75, at.y > 50.0);
    let v = vec3f(a, -a, 7.25) % vec3f(b, 4.0, -2.0);
    let w = vec2f(a, 10.5) % 3.0;
    var c = a;
    c %= b;
    return vec4f(a % 4.0, v.x + v.y * 100.0 + v.z * 10000.0, w.x + w.y * 16.0, c + (5.5 % vec2f(2.0, 3.0)).y);
}
