/// How wet.
#param rain.rate: f32 = 1.0
