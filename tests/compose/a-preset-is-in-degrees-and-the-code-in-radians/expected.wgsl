// ---- sun ----
const sun_azimuth: f32 = 1.5707964;
const sun_pair: vec2f = vec2f(3.1415927, 0.017453292);

// ---- tests/compose/a-preset-is-in-degrees-and-the-code-in-radians/scene.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(sun_azimuth + sun_pair.x);
}
