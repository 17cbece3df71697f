#param sun.azimuth: f32 = 0.0, range -360 .. 360, unit deg
#param sun.pair: vec2f = (0, 0), unit deg

@fragment fn main() -> @location(0) vec4f {
    return vec4f(sun.azimuth + sun.pair.x);
}
