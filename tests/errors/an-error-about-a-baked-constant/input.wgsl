#param sun.power: f32 = 1.0

fn f() -> u32 {
    return sun.power;
}
