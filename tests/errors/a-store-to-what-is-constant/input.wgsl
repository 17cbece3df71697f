fn f() -> f32 {
    let x = 1.0;
    x = 2.0;
    return x;
}
