// ---- land ----
/// How high the land is.
const land_height: f32 = 2000.0;

// ---- land.wgsl ----
/// The land's height at `p`.
fn land_at(p: vec2f) -> f32 {
    return land_height * fract(p.x);
}
