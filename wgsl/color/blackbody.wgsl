// The colour of what glows.

/// Linear sRGB of a black body of `temperature` (K), of luminance 1; 6,600 K is white, near enough.
///
/// From 2,000 to 40,000 K, and held there outside; each channel within .025 of the integral of Planck's law over the CIE
/// 1931 observer (in the matching functions of Wyman, Sloan & Shirley 2013), and within 3 % above 3,000 K.
fn blackbody_color(temperature: f32) -> vec3f {
    let t = 1000.0 / clamp(temperature, 2000.0, 40000.0);
    let red = 0.67263757 + t * (1.06273808 + t * (11.05017235 + t * (-16.66287622 + t * 9.51391381)));
    let green = 0.96557219 + t * (0.66362660 + t * (-4.00723103 + t * (2.90765242 + t * 0.02377500)));
    let blue = 2.30574585 + t * (-9.70709436 + t * (7.14524906 + t * (20.28856796 - t * 28.26953767)));
    return max(vec3f(red, green, blue), vec3f(0.0));
}
