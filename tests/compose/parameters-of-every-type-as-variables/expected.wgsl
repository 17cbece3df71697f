// ---- live parameters: change them here ----
/// Whether it is on.
var<private> set_flag: bool = true;
/// A whole number.
var<private> set_count: i32 = -3;
var<private> set_seed: u32 = 4000000000u;
/// A height.
/// In two lines.
var<private> set_height: f32 = 1800.0;
/// An angle.
var<private> set_angle: f32 = 3.1415927;
var<private> set_pair: vec2f = vec2f(1.0, -2.5);
/// A colour.
var<private> set_tint: vec3f = vec3f(0.32, 0.29, 0.27);
var<private> set_four: vec4f = vec4f(0.001, 2.0, 3.0, 16777216.0);

// ---- input.wgsl ----
// A scene.

@fragment
fn main() -> @location(0) vec4f {
    var v = set_four;
    if set_flag {
        v.x += f32(set_count) + f32(set_seed) * set_height;
    }
    if !set_flag && set_count > 0 {
        v.y = -set_angle;
    }
    v.z = set_tint.r + set_tint.xy.y + dot(set_pair, set_pair.yx);
    return v;
}
