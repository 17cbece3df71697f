fn f(x: vec5f) -> f32 { return 1.0; }
struct S { x: flaot }
