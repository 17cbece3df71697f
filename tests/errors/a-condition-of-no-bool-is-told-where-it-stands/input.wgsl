fn f(x: f32) -> f32 {
    var sum = x;
    if sum {
        return 1.0;
    }
    return 2.0;
}
