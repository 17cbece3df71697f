#param layer.cover: f32 = 1.0
#if layer.soft
#endif
fn f() -> f32 { return layer.covr; }
