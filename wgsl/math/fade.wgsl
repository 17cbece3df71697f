// The fade curve of lattice noises, its slope and its curvature.

/// 6t^5 - 15t^4 + 10t^3: from 0 to 1 with first and second derivative zero at both ends (Perlin 2002). `t` in 0 .. 1.
fn quintic_fade2(t: vec2f) -> vec2f {
    // The nearer half, mirrored: no cancellation toward 1, so that cells meet to the last bits.
    let u = min(t, 1.0 - t);
    let half_way = u * u * u * (u * (u * 6.0 - 15.0) + 10.0);
    return select(half_way, 1.0 - half_way, t > vec2f(0.5));
}

/// Derivative of `quintic_fade2`: 0 .. 1.875.
fn quintic_fade2_slope(t: vec2f) -> vec2f {
    let bump = t * (1.0 - t);
    return 30.0 * bump * bump;
}

/// Second derivative of `quintic_fade2`: -5.7735 .. 5.7735.
fn quintic_fade2_curvature(t: vec2f) -> vec2f {
    return 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t);
}

/// As `quintic_fade2`, in three dimensions.
fn quintic_fade3(t: vec3f) -> vec3f {
    let u = min(t, 1.0 - t);
    let half_way = u * u * u * (u * (u * 6.0 - 15.0) + 10.0);
    return select(half_way, 1.0 - half_way, t > vec3f(0.5));
}

/// Derivative of `quintic_fade3`: 0 .. 1.875.
fn quintic_fade3_slope(t: vec3f) -> vec3f {
    let bump = t * (1.0 - t);
    return 30.0 * bump * bump;
}
