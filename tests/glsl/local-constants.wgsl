// `const` in functions, out of module constants and each other, hiding them, as sizes and selectors.

const N = 4;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    const M = N * 2;
    const HALF = 0.5;
    const UP = vec3f(0.0, HALF, 1);
    const LIST = array(1, M, 3);
    var a: array<i32, M>;
    for (var i = 0; i < M; i++) {
        const N = 10;
        a[i] = i * N;
    }
    if at.x > 30.0 {
        const M = 1u;
        a[M] = 7;
    }
    switch i32(at.y) { case M: { a[0] = 1; } case N: { a[0] = 2; } default: {} }
    return vec4i(a[i32(at.x) % M], a[1], a[0] + i32(UP.y * 2.0 + UP.z), LIST[1] + LIST[i32(at.y) % 3]);
}
