/// How bright a lamp is that is `on`.
fn lamp(on: bool) -> f32 {
    return select(0.0, 1.0, on);
}

@fragment
fn lit(on: bool) -> @location(0) vec4f {
    return vec4f(lamp(on));
}
