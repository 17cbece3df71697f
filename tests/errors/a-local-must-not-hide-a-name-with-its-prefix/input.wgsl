fn f() -> f32 {
    return 1.0;
}

fn g() -> f32 {
    let og_f = 2.0;
    return og_f + f();
}
