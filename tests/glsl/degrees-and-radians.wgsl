// tolerance: 1e-6 relative, since both multiply by a rounded constant
// From radians and back.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x) - 20.0;
    let v = radians(vec2f(x, floor(at.y)));
    return vec4f(degrees(x), radians(x), v.y, degrees(vec3f(x, 1.0, at.y)).z);
}
