#param one.a: f32 = 1.0
#param two.a: vec2f = (1, 2)
#param one.b: u32 = 2
#param three.a: vec3f = (1, 2, 3)
#param four.a: f32 = 1.0

fn f() -> f32 {
    return one.a + f32(one.b) + two.a.x + three.a.x + four.a;
}
