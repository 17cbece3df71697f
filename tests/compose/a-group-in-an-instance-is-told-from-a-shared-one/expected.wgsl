// ---- high ----
const high_cover: f32 = 0.5;
// ---- sun ----
const sun_power: f32 = 4.0;

// ---- layer.wgsl as high ----
fn high_light() -> f32 {
    return high_cover * sun_power;
}

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(high_light());
}
