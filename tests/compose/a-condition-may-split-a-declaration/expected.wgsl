fn light(distance: f32) -> f32 {
    let k = 2.0;
    return k * distance;
}

struct Hit {
    at: f32,
}

@fragment fn main() -> @location(0) vec4f {
    return vec4f(light(Hit(1.0).at));
}
