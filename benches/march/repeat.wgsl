// Each ray many times over, a little beside itself: what is timed is then the march, not its compilation.

fn repeat_adaptive(p: vec3f, d: vec3f, far: f32, ceiling: f32, how: adaptive_Adaptive, times: i32) -> f32 {
    var sum = 0.0;
    for (var i = 0; i < times; i++) {
        sum += adaptive_march(p + vec3f(0.01 * f32(i), 0.0, 0.0), d, ceiling, far, how).distance;
    }
    return sum;
}

fn repeat_bounded(p: vec3f, d: vec3f, far: f32, how: bounded_Bounded, times: i32) -> f32 {
    var sum = 0.0;
    for (var i = 0; i < times; i++) {
        sum += bounded_march(p + vec3f(0.01 * f32(i), 0.0, 0.0), d, 0.0, far, how).distance;
    }
    return sum;
}
