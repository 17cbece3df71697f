#param sea.level: f32 = 0.0, unit m
