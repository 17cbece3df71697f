#param sun.power: f32 = 1.0
fn sun() -> f32 { return 1.0; }
@fragment fn main() -> @location(0) vec4f {
    return vec4f(sun.power);
}
