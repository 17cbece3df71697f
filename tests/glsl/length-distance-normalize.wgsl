// tolerance: 2e-6 relative, since WGSL's length inherits the error of sqrt(dot)
// Of vectors, and of scalars, for which length is abs.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy) - vec2f(31.5);
    return vec4f(
        length(p) + length(p.x),
        distance(vec3f(p, 1.0), vec3f(2.0, 3.0, 4.0)) + distance(p.y, 100.0),
        normalize(p).x,
        normalize(vec3f(p, 0.5)).z + length(vec4f(p, p)),
    );
}
