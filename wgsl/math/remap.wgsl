// Linear maps between intervals.

/// `value` carried linearly from `a .. b` to `c .. d`; outside of `a .. b` it goes on along the same line.
///
/// `a` and `b` must differ.
fn remap(value: f32, a: f32, b: f32, c: f32, d: f32) -> f32 {
    return c + (d - c) * ((value - a) / (b - a));
}

/// As `remap`, held between `c` and `d`.
fn remap_clamped(value: f32, a: f32, b: f32, c: f32, d: f32) -> f32 {
    return c + (d - c) * clamp((value - a) / (b - a), 0.0, 1.0);
}

/// Where `value` lies between `a` and `b`: 0 at or before `a`, 1 at or after `b`, linear between. `a` and `b` must
/// differ.
fn linear_step(a: f32, b: f32, value: f32) -> f32 {
    return clamp((value - a) / (b - a), 0.0, 1.0);
}

/// The smaller of `a` and `b` with the corner rounded over `radius` > 0; at most `radius / 4` below the true minimum.
///
/// Quadratic polynomial blend.
fn smooth_min(a: f32, b: f32, radius: f32) -> f32 {
    let overlap = max(radius - abs(a - b), 0.0) / radius;
    return min(a, b) - 0.25 * overlap * overlap * radius;
}

/// The larger of `a` and `b` with the corner rounded over `radius` > 0; at most `radius / 4` above the true maximum.
fn smooth_max(a: f32, b: f32, radius: f32) -> f32 {
    return -smooth_min(-a, -b, radius);
}
