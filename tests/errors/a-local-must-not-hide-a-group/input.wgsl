#param sun.power: f32 = 1.0

fn light(sun: f32) -> f32 {
    let power = sun;
    return power;
}

@fragment fn main() -> @location(0) vec4f {
    return vec4f(light(sun.power));
}
