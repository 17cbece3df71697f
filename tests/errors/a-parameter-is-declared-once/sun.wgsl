#param sun.power: f32 = 2.0
