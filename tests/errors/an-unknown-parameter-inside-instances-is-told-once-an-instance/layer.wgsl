#param layer.cover: f32 = 1.0
fn f() -> f32 { return layer.covr; }
const_assert 1 == 1;
const X = f();
