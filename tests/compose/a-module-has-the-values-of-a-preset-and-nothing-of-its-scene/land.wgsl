/// How high the land is.
#param land.height: f32 = 1000.0, unit m

/// The land's height at `p`.
fn land_at(p: vec2f) -> f32 {
    return land.height * fract(p.x);
}
