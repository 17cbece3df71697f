// step gives 1 at the edge itself; smoothstep is a cubic between its edges.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let f = floor(at.x) - 32.0;
    let g = floor(at.y) - 32.0;
    return vec4f(
        step(f, g) + 2.0 * step(0.0, f),
        step(vec2f(3.0, g), vec2f(f)).x + 10.0 * step(vec2f(3.0, g), vec2f(f, 0.0)).y,
        smoothstep(-16.0, 16.0, f),
        smoothstep(vec2f(0.0), vec2f(4.0, 8.0), vec2f(f, g)).y,
    );
}
