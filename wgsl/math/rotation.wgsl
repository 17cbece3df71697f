// Rotations and directions. y is up, north is -z, east is +x.

/// `p` turned by `angle` (rad), counter-clockwise when x points right and y up. Keeps lengths.
fn rotate2(p: vec2f, angle: f32) -> vec2f {
    let c = cos(angle);
    let s = sin(angle);
    return vec2f(c * p.x - s * p.y, s * p.x + c * p.y);
}

/// Unit vector toward `azimuth` (rad, clockwise from north as on a compass) and `elevation` (rad above the horizon).
fn direction_from_angles(azimuth: f32, elevation: f32) -> vec3f {
    let level = cos(elevation);
    return vec3f(level * sin(azimuth), sin(elevation), -level * cos(azimuth));
}

/// `v` without its length; `fallback` where `v` is too short to have a direction.
fn normalize_or(v: vec3f, fallback: vec3f) -> vec3f {
    let length2 = dot(v, v);
    if length2 < 1e-20 {
        return fallback;
    }
    return v * inverseSqrt(length2);
}
