// What is out of an integer's range becomes its nearest number; else the fraction goes.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let scale = exp2(floor(at.y) - 8.0);
    let f = (floor(at.x) - 31.75) * scale;
    let v = vec2i(vec2f(f, -f));
    let w = vec3u(vec3f(f, -f, 1.9));
    return vec4i(i32(f), bitcast<i32>(u32(f)), v.y, bitcast<i32>(w.y) + i32(w.z));
}
