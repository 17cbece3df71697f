fn two() -> f32 { return 0.5; }
