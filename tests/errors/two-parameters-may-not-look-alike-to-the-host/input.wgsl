#param a.b_c: f32 = 1.0
#param a_b.c: f32 = 1.0
