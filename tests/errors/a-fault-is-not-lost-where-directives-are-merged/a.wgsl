fn twice() -> f32 { return 1.0; }
fn twice() -> f32 { return 2.0; }
