#param a.x: f32 = 1.0
#param b.x: f32 = 2.0

fn first() -> f32 {
    return third() + a.x;
}

fn second() -> f32 {
    return b.x;
}

fn third() -> f32 {
    return 3.0;
}

@compute @workgroup_size(1)
fn main() {
    _ = second();
}
