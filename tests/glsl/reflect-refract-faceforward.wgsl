// tolerance: 1e-5 absolute, since WGSL's refract inherits the errors of dot and sqrt
// faceForward is spelled otherwise in GLSL; past the critical angle refract gives zero.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = (floor(at.x) - 32.0) / 64.0;
    let n = vec3f(0.0, 1.0, 0.0);
    let i = vec3f(a, -sqrt(1.0 - a * a), 0.0);
    let eta = select(0.75, 1.6, at.y > 32.0);
    let up = faceForward(n, i, vec3f(0.0, floor(at.y) - 20.5, 0.0));
    let flat2 = faceForward(vec2f(1.0, 2.0), vec2f(a, 1.0), vec2f(1.0, 0.3));
    return vec4f(reflect(i, n).xy + up.xy, refract(i, n, eta).xy + flat2);
}
