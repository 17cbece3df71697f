#param sun.elevation: f32 = 18.0
#param sun.azimuth: f32 = 18.0
