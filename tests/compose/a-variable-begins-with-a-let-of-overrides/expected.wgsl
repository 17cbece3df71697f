// ---- cloud ----
override cloud_coverage: f32 = 0.3;

// ---- input.wgsl ----
@fragment
fn main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let share = mix(0.8, 1.0, cloud_coverage);
    var sunny = 1.0 - cloud_coverage * share;
    sunny *= position.x;
    return vec4f(sunny);
}
