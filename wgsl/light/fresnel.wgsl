// Fresnel reflectance of a smooth boundary between two dielectrics.

/// Reflectance of unpolarised light (Fresnel's equations, exact).
///
/// `cos_theta`: cosine between normal and incoming direction, 0 .. 1. `ior`: refractive index of the far side over the
/// near side (air to water 1.333, water to air 0.750). Returns 0 .. 1, and 1 past the critical angle.
fn fresnel_dielectric(cos_theta: f32, ior: f32) -> f32 {
    let sin2_refracted = (1.0 - cos_theta * cos_theta) / (ior * ior); // Snell
    if sin2_refracted >= 1.0 {
        return 1.0; // total internal reflection
    }
    let cos_refracted = sqrt(1.0 - sin2_refracted);
    let parallel = (ior * cos_theta - cos_refracted) / (ior * cos_theta + cos_refracted);
    let perpendicular = (cos_theta - ior * cos_refracted) / (cos_theta + ior * cos_refracted);
    return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

/// Reflectance at normal incidence, for `ior` as in `fresnel_dielectric`. 0 .. 1.
fn fresnel_normal(ior: f32) -> f32 {
    let ratio = (ior - 1.0) / (ior + 1.0);
    return ratio * ratio;
}

/// Schlick's approximation (1994) of a reflectance that is `at_normal` for light along the normal: cheap, and with a
/// colour also good for metals.
///
/// `cos_theta` 0 .. 1; returns `at_normal` .. 1. For water it errs by up to 23 % of the true value, or .06.
fn fresnel_schlick(cos_theta: f32, at_normal: vec3f) -> vec3f {
    let away = 1.0 - clamp(cos_theta, 0.0, 1.0);
    let away2 = away * away;
    return at_normal + (1.0 - at_normal) * (away2 * away2 * away);
}
