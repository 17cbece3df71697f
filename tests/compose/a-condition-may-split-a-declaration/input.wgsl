#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

#if scene.fog
fn light(distance: f32) -> f32 {
    let k = 2.0;
#else
fn light(distance: f32) -> f32 {
    let k = 3.0;
#endif
    return k * distance;
}

struct Hit {
    at: f32,
#if plain
    normal: vec3f,
#endif
}

@fragment fn main() -> @location(0) vec4f {
    return vec4f(light(Hit(1.0).at));
}
