// The same name in blocks side by side, of different types.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    var r = vec4f();
    { let v = p.x; r.x += v; }
    { let v = p; r.y += v.y; }
    { var v = vec3u(vec2u(p), 7u); v.x += 1u; r.z += f32(v.x + v.z); }
    for (var v = 0; v < 3; v++) { r.w += f32(v); }
    for (var v = p.y; v < 5.0; v += 1.0) { r.w += v; }
    if p.x > 3.0 { let v = mat2x2f(1.0, 2.0, 3.0, 4.0); r.w += v[1].x; } else { let v = true; r.w += f32(v); }
    return r;
}
