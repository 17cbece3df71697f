// -m is not WGSL; -1.0 * m is, and numbers scale matrices from both sides.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let m = mat2x2f(p, vec2f(3.0, 4.0));
    let n = -1.0 * m * 2.0 - m * 0.5;
    var k = n;
    k *= 2.0;
    k[0] = -k[0];
    return vec4f(n[0], k[1].x + k[0].y, (m * n * p).x);
}
