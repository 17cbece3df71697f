#slot step1: fn(x: f32) -> f32

fn once(x: f32) -> f32 {
    return step1(x);
}
