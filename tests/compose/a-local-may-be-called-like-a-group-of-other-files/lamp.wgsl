/// How bright it is.
#param sun.power: f32 = 1.0

fn lamp() -> f32 {
    return sun.power;
}
