#param sun.power: f32 = 4.0
