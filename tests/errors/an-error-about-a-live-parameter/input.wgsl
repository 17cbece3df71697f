#param sun.power: f32 = 1.0

fn f() -> f32 {
    return sun.power + 1u;
}
