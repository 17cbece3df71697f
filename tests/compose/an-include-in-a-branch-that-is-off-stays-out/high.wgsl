fn value() -> f32 { return 1.0; }
