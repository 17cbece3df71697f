// How matt and glossy surfaces scatter light: BRDFs (1 / sr), to be multiplied by irradiance.
//
// A surface with `from_light` irradiance measured facing the light has radiance brdf · from_light · max(dot(normal,
// to_light), 0). All are normalised: from whatever direction light comes, no more leaves than came.

/// Lambert's: the same radiance in every direction. `albedo` is the part of the light that is scattered.
fn lambert_brdf(albedo: vec3f) -> vec3f {
    return albedo * 0.31830989;
}

/// Phong's highlight (1975) around the mirror direction, with `shininess` >= 0: larger is narrower.
///
/// Normalised by (n + 2) / 2 pi (Lafortune & Willems 1994): reflects 1 of light along the normal, less from the side.
/// All directions are unit vectors that point away from the surface.
fn phong_brdf(normal: vec3f, to_light: vec3f, to_eye: vec3f, shininess: f32) -> f32 {
    let mirrored = 2.0 * dot(normal, to_light) * normal - to_light;
    let toward = max(dot(mirrored, to_eye), 0.0);
    return (shininess + 2.0) * 0.15915494 * specular_power(toward, shininess);
}

/// Blinn's highlight (1977) around the half-way vector, with `shininess` >= 0: larger is narrower; for the same look four
/// times Phong's.
///
/// Normalised so that light along the normal is reflected in full: by (n + 2)(n + 4) / (8 pi (2^(-n/2) + n)) (Giesen
/// 2009).
fn blinn_phong_brdf(normal: vec3f, to_light: vec3f, to_eye: vec3f, shininess: f32) -> f32 {
    let both = to_light + to_eye;
    let length2 = dot(both, both);
    if length2 < 1e-12 {
        return 0.0; // the eye looks straight along the light: there is no half-way
    }
    let toward = max(dot(normal, both) * inverseSqrt(length2), 0.0);
    let scale = (shininess + 2.0) * (shininess + 4.0) / (25.132741 * (exp2(-0.5 * shininess) + shininess));
    return scale * specular_power(toward, shininess);
}

/// `base`^`exponent` for `base` 0 .. 1, defined at 0 too.
fn specular_power(base: f32, exponent: f32) -> f32 {
    return exp2(exponent * log2(max(base, 1e-30)));
}
