// Beside the host's own shader.

/// How much.
fn beside_weight() -> f32 {
    return 2.0;
}
