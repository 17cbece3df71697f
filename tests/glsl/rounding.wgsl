// floor, ceil, trunc, fract and round, which takes halves to the even neighbour.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let f = (floor(at.x) - 32.0) * 0.25;
    let v = vec2f(f, floor(at.y) - 31.5);
    let r = round(vec3f(f, -f, v.y));
    return vec4f(
        floor(f) + ceil(f) * 100.0 + trunc(f) * 10000.0,
        round(f) + 100.0 * round(v).y,
        fract(f) + fract(v).x * 64.0,
        r.x + r.y * 100.0 + r.z * 10000.0 + trunc(-v).y + floor(v).y + ceil(v).x,
    );
}
