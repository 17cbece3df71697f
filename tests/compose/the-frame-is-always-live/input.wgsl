#param frame.time: f32 = 0.0, unit s
#param a.y: f32 = 2.0

@fragment fn main() -> @location(0) vec4f {
    return vec4f(frame.time + a.y);
}
