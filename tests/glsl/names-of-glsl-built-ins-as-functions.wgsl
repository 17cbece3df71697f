// Functions of the author's called like GLSL's own, with other meanings.

fn fma(a: f32, b: f32) -> f32 {
    return a - b * trunc(a / b) + 100.0;
}

fn noise(p: vec2f) -> f32 {
    return p.x * 0.5 + p.y;
}

fn lessThan(a: vec2f, b: vec2f) -> f32 {
    return select(0.0, 1.0, all(a < b));
}

fn texture(a: f32) -> f32 {
    return a + 1.0;
}

fn outerProduct(a: vec2f) -> vec2f {
    return a.yx;
}

fn matrixCompMult(a: f32) -> f32 {
    return -a;
}

fn dFdx(a: f32) -> f32 {
    return a * 3.0;
}

fn roundEven(a: f32) -> f32 {
    return floor(a) + 0.25;
}

fn isnan(a: f32) -> bool {
    return a > 3.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let nan = select(0.0, 10.0, isnan(p.x));
    return vec4f(
        fma(p.x, 4.0) + noise(p),
        lessThan(p, p.yx) + texture(p.x),
        outerProduct(p).x + matrixCompMult(p.y),
        dFdx(p.x) + roundEven(p.y) + nan,
    );
}
