// The sRGB transfer function (IEC 61966-2-1), exact, both ways.

/// Linear light to display values. Keeps sign; goes on above 1 along the same curve, so that it can be undone
/// there too.
fn srgb_encode(linear_light: vec3f) -> vec3f {
    let magnitude = abs(linear_light);
    let low = magnitude * 12.92;
    let high = 1.055 * pow(magnitude, vec3f(1.0 / 2.4)) - 0.055;
    return sign(linear_light) * select(high, low, magnitude <= vec3f(0.0031308));
}

/// Display values to linear light: the inverse of `srgb_encode`.
fn srgb_decode(encoded: vec3f) -> vec3f {
    let magnitude = abs(encoded);
    let low = magnitude / 12.92;
    let high = pow((magnitude + 0.055) / 1.055, vec3f(2.4));
    return sign(encoded) * select(high, low, magnitude <= vec3f(0.04045));
}

/// Luminance of linear sRGB (Rec. 709 primaries): 1 for white.
fn luminance(linear_light: vec3f) -> f32 {
    return dot(linear_light, vec3f(0.2126, 0.7152, 0.0722));
}
