fn f() -> f32 {
    retrun 1.0;
}
