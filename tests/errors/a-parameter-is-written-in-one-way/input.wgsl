#param
#param x: f32 = 1.0
#param a.x f32 = 1.0
#param a.x: vec3 = (0, 0, 0)
#param a.x: f32
#param a.x: f32 = one
#param a.x: f32 = 1.0 range 0 .. 1
#param a.x: f32 = 1.0, rang 0 .. 1
#param a.x: f32 = 1.0, range 0 - 1
#param a.x: vec2f = 1.0
#param a.x: vec2f = (1.0, 2.0
#param a.x: bool = 1
#param a._x: f32 = 1.0
#param a.x: f32 = 1.0, unit
#param a.x: f32 = 1.5f
