/// How high.
#param land.height: f32 = 10.0
