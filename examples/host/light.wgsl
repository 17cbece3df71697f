// The light of printed maps: from the north-west.

/// Brightness, 0 .. 1, of ground whose height has the gradient `slope`.
fn light_from_the_north_west(slope: vec2f) -> f32 {
    let normal = normalize(vec3f(-slope.x, 1.0, -slope.y));
    return saturate(dot(normal, normalize(vec3f(-1.0, 1.2, -1.0))));
}
