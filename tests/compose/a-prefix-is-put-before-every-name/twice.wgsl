#slot step2: fn(x: f32) -> f32

/// Two steps.
fn twice(x: f32) -> f32 {
    return step2(step2(x));
}
