fn helper() -> f32 { return 2.0; }
