struct S { x: f32 };
fn g() -> f32 { return 1.0; }