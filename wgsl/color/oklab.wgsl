// Oklab: lightness and two axes of colour in which equal steps look equal (Ottosson 2020, "A perceptual color space for
// image processing").

/// Linear sRGB of the Oklab colour `lab` (lightness 0 .. 1, green to red, blue to yellow). Not every colour is within
/// sRGB: channels outside of 0 .. 1 are left so.
fn oklab_to_linear(lab: vec3f) -> vec3f {
    let cones = vec3f(
        lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z,
        lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z,
        lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z,
    );
    let cubed = cones * cones * cones;
    return vec3f(
        dot(cubed, vec3f(4.0767416621, -3.3077115913, 0.2309699292)),
        dot(cubed, vec3f(-1.2684380046, 2.6097574011, -0.3413193965)),
        dot(cubed, vec3f(-0.0041960863, -0.7034186147, 1.7076147010)),
    );
}

/// Oklab of linear sRGB, each channel >= 0: the inverse of `oklab_to_linear`.
fn oklab_from_linear(linear_light: vec3f) -> vec3f {
    let cones = vec3f(
        dot(linear_light, vec3f(0.4122214708, 0.5363325363, 0.0514459929)),
        dot(linear_light, vec3f(0.2119034982, 0.6806995451, 0.1073969566)),
        dot(linear_light, vec3f(0.0883024619, 0.2817188376, 0.6299787005)),
    );
    let rooted = pow(max(cones, vec3f(0.0)), vec3f(1.0 / 3.0));
    return vec3f(
        dot(rooted, vec3f(0.2104542553, 0.7936177850, -0.0040720468)),
        dot(rooted, vec3f(1.9779984951, -2.4285922050, 0.4505937099)),
        dot(rooted, vec3f(0.0259040371, 0.7827717662, -0.8086757660)),
    );
}
