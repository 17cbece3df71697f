fn value() -> f32 { return 1.0; } // laid over
