struct OrogenParams {
    /// Whether it is on.
    set_flag: u32,
    /// A whole number.
    set_count: i32,
    set_seed: u32,
    /// A height.
    /// In two lines.
    set_height: f32,
    /// An angle.
    set_angle: f32,
    set_pair: vec2f,
    /// A colour.
    set_tint: vec3f,
    set_four: vec4f,
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- input.wgsl ----
// A scene.

@fragment
fn main() -> @location(0) vec4f {
    var v = orogen.set_four;
    if (orogen.set_flag != 0u) {
        v.x += f32(orogen.set_count) + f32(orogen.set_seed) * orogen.set_height;
    }
    if !(orogen.set_flag != 0u) && orogen.set_count > 0 {
        v.y = -orogen.set_angle;
    }
    v.z = orogen.set_tint.r + orogen.set_tint.xy.y + dot(orogen.set_pair, orogen.set_pair.yx);
    return v;
}
