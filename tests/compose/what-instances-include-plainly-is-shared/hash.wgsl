#param random.seed: f32 = 7.0
fn hash() -> f32 { return random.seed; }
