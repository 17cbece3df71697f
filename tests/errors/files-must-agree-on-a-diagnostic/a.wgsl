diagnostic(error, derivative_uniformity);
fn a() -> f32 { return 1.0; }
