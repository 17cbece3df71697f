// ---- sun ----
/// How bright it is.
const sun_power: f32 = 1.0;

// ---- lamp.wgsl ----
fn lamp() -> f32 {
    return sun_power;
}

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    let sun = vec2f(0.5, 1.0);
    return vec4f(sun.x * lamp(), sun, 1.0);
}
