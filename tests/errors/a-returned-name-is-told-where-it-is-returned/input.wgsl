fn f(x: i32) -> f32 {
    let sum = x + 1;
    return sum;
}
