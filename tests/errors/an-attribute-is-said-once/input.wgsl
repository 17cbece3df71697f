#param sun.height: f32 = 0.5, range 0 .. 1, range 0 .. 2
