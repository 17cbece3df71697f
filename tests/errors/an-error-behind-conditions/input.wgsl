#option a.on = true

fn f() -> f32 {
#if !a.on
    return 1.0;
#else
    let x = 1.0;
    return x + vec2f(1.0);
#endif
}
