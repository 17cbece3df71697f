// ---- set ----
/// Whether it is on.
override set_flag: bool = true;
/// A whole number.
override set_count: i32 = -3;
override set_seed: u32 = 4000000000u;
/// A height.
/// In two lines.
override set_height: f32 = 1800.0;
override set_pair_x: f32 = 1.0;
override set_pair_y: f32 = -2.5;
override set_four_x: f32 = 0.001;
override set_four_y: f32 = 2.0;
override set_four_z: f32 = 3.0;
override set_four_w: f32 = 16777216.0;
struct OrogenParams {
    /// An angle.
    set_angle: f32,
    /// A colour.
    set_tint: vec3f,
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- input.wgsl ----
// A scene.

@fragment
fn main() -> @location(0) vec4f {
    var v = vec4f(set_four_x, set_four_y, set_four_z, set_four_w);
    if set_flag {
        v.x += f32(set_count) + f32(set_seed) * set_height;
    }
    if !set_flag && set_count > 0 {
        v.y = -orogen.set_angle;
    }
    v.z = orogen.set_tint.r + orogen.set_tint.xy.y + dot(vec2f(set_pair_x, set_pair_y), vec2f(set_pair_x, set_pair_y).yx);
    return v;
}
