// A loop over floats, with the counter's rounding, ending where it ends in f32.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var t = 0.0;
    var n = 0.0;
    for (var s = 0.0; s < floor(at.x) * 0.125; s += 0.0625) { t += s; n += 1.0; }
    var w = 1.0;
    while w < floor(at.y) { w *= 1.5; }
    return vec4f(t, n, w, 0.0);
}
