// The fade curve of lattice noises, its slope and its curvature.

/// 6t^5 - 15t^4 + 10t^3: from 0 to 1 with first and second derivative zero at both ends (Perlin 2002). `t` in 0 .. 1.
fn quintic_fade2(t: vec2f) -> vec2f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Derivative of `quintic_fade2`: 0 .. 1.875.
fn quintic_fade2_slope(t: vec2f) -> vec2f {
    return 30.0 * t * t * (t * (t - 2.0) + 1.0);
}

/// Second derivative of `quintic_fade2`: -5.7735 .. 5.7735.
fn quintic_fade2_curvature(t: vec2f) -> vec2f {
    return 60.0 * t * (t * (2.0 * t - 3.0) + 1.0);
}

/// As `quintic_fade2`, in three dimensions.
fn quintic_fade3(t: vec3f) -> vec3f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Derivative of `quintic_fade3`: 0 .. 1.875.
fn quintic_fade3_slope(t: vec3f) -> vec3f {
    return 30.0 * t * t * (t * (t - 2.0) + 1.0);
}
