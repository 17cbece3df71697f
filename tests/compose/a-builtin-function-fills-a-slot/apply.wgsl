#slot shape: fn(x: f32) -> f32
#slot tone: fn(x: f32) -> f32
fn applied(x: f32) -> f32 { return tone(shape(x)); }
