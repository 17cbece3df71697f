fn value() -> f32 { return 0.0; } // below
