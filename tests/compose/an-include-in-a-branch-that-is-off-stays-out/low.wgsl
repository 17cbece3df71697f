fn value() -> f32 { return 0.5; }
