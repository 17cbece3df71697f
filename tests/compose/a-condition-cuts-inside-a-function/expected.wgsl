/// What it gives depends on the fog.
fn light(
    distance: f32,
    density: f32,
) -> f32 {
    var sum = distance;
    sum *= exp(-density);

    return sum;
}

@fragment
fn main() -> @location(0) vec4f {
    return vec4f(light(1.0, 2.0));
}
