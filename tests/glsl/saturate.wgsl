// The same as clamping to 0 .. 1.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = (floor(at.xy) - 32.0) / 16.0;
    return vec4f(saturate(p.x), saturate(p), saturate(vec3f(p.y, 2.0, -1.0)).x + saturate(0.25));
}
