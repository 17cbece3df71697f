// @must_use, @diagnostic and @interpolate say nothing to GLSL.

diagnostic(off, derivative_uniformity);

@must_use
fn f(x: f32) -> f32 {
    return x * 2.0;
}

@diagnostic(off, derivative_uniformity)
fn g(x: f32) -> f32 {
    if x > 3.0 {
        return f(x);
    }
    return x;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    return vec4f(f(floor(at.x)), g(floor(at.y)), 0.0, 1.0);
}
