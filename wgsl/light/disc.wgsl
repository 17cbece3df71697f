// Discs in the sky: how the sun darkens toward its limb, how the moon is lit, and how a disc is drawn among pixels.

/// Radiance of the sun's disc over its mean, in red, green and blue.
///
/// `mu`: cosine between the sun's surface normal and the eye there, 0 (the limb) .. 1 (the middle). The power law of
/// Hestroffer & Magnan (1998), exponents .292 / wavelength (µm) - .023 at 680, 550 and 440 nm: the limb is dimmer and
/// redder. Its mean over the disc is 1; 0 .. 1.33.
fn sun_limb(mu: f32) -> vec3f {
    let exponent = vec3f(0.40641, 0.50791, 0.64064);
    return (1.0 + 0.5 * exponent) * pow(vec3f(clamp(mu, 0.0, 1.0)), exponent);
}

/// Light of the moon over that of the full moon, at `phase_angle` (rad): 0 at full moon, pi/2 at the quarters (where it
/// is .091), pi at new moon.
///
/// .026 magnitudes a degree and 4e-9 of its fourth power (Allen 1976, "Astrophysical Quantities"). Goes down from 1 to
/// 2.8e-4.
fn moon_phase_law(phase_angle: f32) -> f32 {
    let degrees = clamp(phase_angle, 0.0, 3.14159265) * 57.2957795;
    let squared = degrees * degrees;
    return exp2(-1.3287712 * (0.026 * degrees + 4e-9 * squared * squared));
}

/// Radiance of a place of the moon's disc over that of the full moon, without seas and earthshine. 0 .. 2.
///
/// `mu_sun`, `mu_eye`: cosines between the surface normal and the sun, and the eye. Lommel and Seeliger's law, by which
/// the full moon is as light at its limb as in its middle; scaled so that the whole disc gives `moon_phase_law`.
fn moon_scattering(mu_sun: f32, mu_eye: f32, phase_angle: f32) -> f32 {
    if mu_sun <= 0.0 {
        return 0.0;
    }
    let half_angle = clamp(0.5 * phase_angle, 0.0, 1.5707);
    // What Lommel and Seeliger's law gives for the whole disc.
    let quarter_tan = max(tan(0.5 * half_angle), 1e-6);
    let whole = 1.0 + sin(half_angle) * tan(half_angle) * log(quarter_tan);
    let scale = min(moon_phase_law(phase_angle) / max(whole, 1e-4), 1.0);
    return scale * 2.0 * mu_sun / (mu_sun + max(mu_eye, 1e-3));
}

/// How much of a disc a pixel shows: 1 within it, 0 from a pixel outside of it, and between them down to 2^-`decline` on a
/// logarithmic ramp, so that the edge is smooth even where light is shown on a curve that presses bright discs to white.
///
/// `away`: distance from the disc's middle in radii, `pixel`: a pixel's width in radii.
fn disc_coverage(away: f32, pixel: f32, decline: f32) -> f32 {
    let inside = clamp((1.0 - away) / max(pixel, 1e-6) + 1.0, 0.0, 1.0);
    return inside * exp2((inside - 1.0) * decline);
}
