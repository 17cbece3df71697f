// A scene.

/// Whether it is on.
#param set.flag: bool = true
/// A whole number.
#param set.count: i32 = -3, range -10 .. 10
#param set.seed: u32 = 4000000000
/// A height.
/// In two lines.
#param set.height: f32 = 1800.0, range 0 .. 8000, unit m
/// An angle.
#param set.angle: f32 = 180.0, unit deg
#param set.pair: vec2f = (1.0, -2.5)
/// A colour.
#param set.tint: vec3f = (0.32, 0.29, 0.27), color
#param set.four: vec4f = (1e-3, 2, 3, 16777217)
/// Nobody reads this one.
#param set.unread: f32 = 1.0

@fragment
fn main() -> @location(0) vec4f {
    var v = set.four;
    if set.flag {
        v.x += f32(set.count) + f32(set.seed) * set.height;
    }
    if !set.flag && set.count > 0 {
        v.y = -set.angle;
    }
    v.z = set.tint.r + set.tint.xy.y + dot(set.pair, set.pair.yx);
    return v;
}
