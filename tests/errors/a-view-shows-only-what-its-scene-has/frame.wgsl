/// When.
#param frame.time: f32 = 1.0, live
