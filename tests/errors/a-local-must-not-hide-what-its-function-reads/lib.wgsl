fn f(x: f32) -> f32 {
    let my_g = g(x);
    return my_g;
}
fn g(x: f32) -> f32 { return x; }
