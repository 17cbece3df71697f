#param a.x: f32 = 1.0
#param b.y: f32 = 1.0
