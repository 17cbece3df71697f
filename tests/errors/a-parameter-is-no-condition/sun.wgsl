#param sun.elevation: f32 = 18.0
