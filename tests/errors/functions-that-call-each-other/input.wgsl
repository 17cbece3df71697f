fn a() -> f32 { return b(); }
fn b() -> f32 { return a(); }
