#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

/// What it gives depends on the fog.
fn light(
    distance: f32,
#if scene.fog
    density: f32,
#endif
) -> f32 {
    var sum = distance;
#if scene.fog
    sum *= exp(-density);
#else
    sum = 0.0;
#endif

    return sum;
}

@fragment
fn main() -> @location(0) vec4f {
#if scene.fog
    return vec4f(light(1.0, 2.0));
#else
    return vec4f(light(1.0));
#endif
}
