fn f() -> f32 {
    #param a.x: f32 = 1.0
    #include <a.wgsl>
    return a.x;
}
