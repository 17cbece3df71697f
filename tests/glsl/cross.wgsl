// The right-handed vector product.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let a = vec3f(floor(at.xy), 3.0);
    let b = vec3f(-2.0, 5.0, floor(at.x));
    return vec4f(cross(a, b), cross(b, a).y);
}
