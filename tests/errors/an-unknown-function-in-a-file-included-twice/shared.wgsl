// Shared.

fn shared_noise() -> f32 {
    return shared_nois(1.0);
}
