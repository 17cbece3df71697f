fn shared_value() -> f32 { return 0.25; }
