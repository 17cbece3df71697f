#param a.x: f32 = 1.0, live
#param a.y: f32 = 2.0

@fragment fn main() -> @location(0) vec4f {
    return vec4f(a.x + a.y);
}
