// Of vectors of every size; small whole numbers, so that the order of the sum does not count.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    return vec4f(
        dot(p, p.yx),
        dot(vec3f(p, 3.0), vec3f(1.0, -2.0, 5.0)),
        dot(vec4f(p, 1.0, 2.0), vec4f(p.yx, 3.0, 0.5)),
        dot(p - 3.0, vec2f(1.0)),
    );
}
