/// How high.
#param land.height: f32 = 10.0
/// How wet.
#param water.level: f32 = 1.0
/// How cold.
#param snow.line: f32 = 2.0
