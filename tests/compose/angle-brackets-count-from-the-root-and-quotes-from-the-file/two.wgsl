fn two() -> f32 { return 0.0; } // at the root
