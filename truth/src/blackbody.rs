//! The colour of a black body: Planck's law over the eye's matching functions.

/// Linear sRGB of a black body of `temperature` (K), of luminance 1.
///
/// The matching functions are those of Wyman, Sloan & Shirley (2013, "Simple Analytic Approximations to the CIE XYZ Color
/// Matching Functions", JCGT 2(2)), several lobes each; nanometre by nanometre.
#[must_use]
pub fn linear_srgb(temperature: f64) -> [f64; 3] {
    let mut xyz = [0.0; 3];
    for nanometre in 380..=780 {
        let wavelength = f64::from(nanometre);
        let power = wavelength.powi(-5) / ((1.4388e7 / (wavelength * temperature)).exp() - 1.0);
        for (sum, matching) in xyz.iter_mut().zip(matching(wavelength)) {
            *sum += power * matching;
        }
    }
    let [x, y, z] = xyz.map(|sum| sum / xyz[1]);
    [
        3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
        -0.969_266_0 * x + 1.876_010_8 * y + 0.041_556_0 * z,
        0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
    ]
}

/// The CIE 1931 observer's three matching functions at `wavelength` (nm).
fn matching(wavelength: f64) -> [f64; 3] {
    let lobe = |height: f64, middle: f64, below: f64, above: f64| {
        let width = if wavelength < middle { below } else { above };
        height * (-0.5 * ((wavelength - middle) / width).powi(2)).exp()
    };
    [
        lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) - lobe(0.065, 501.1, 20.4, 26.2),
        lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
        lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8),
    ]
}
