// quantizeToF16 of numbers that a half can hold exactly is the number itself.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = (floor(at.xy) - 30.0) * vec2f(0.125, 64.0);
    return vec4f(quantizeToF16(p.x), quantizeToF16(p), quantizeToF16(vec3f(p, 0.5)).z);
}
