//! How light it is out of doors as the sun sinks.

/// Illuminance (lx) of level ground for the sun at `degrees` of elevation (Janiczek & DeYoung 1987, "Computer Programs for
/// Sun and Moon Illuminance", US Naval Observatory Circular 171): ten to the power of a cubic, another for each stretch.
#[must_use]
pub fn illuminance(degrees: f64) -> f64 {
    const STRETCHES: [(f64, [f64; 4]); 6] = [
        (20.0, [3.74, 3.97, -4.07, 1.47]),
        (5.0, [3.05, 13.28, -45.98, 64.33]),
        (-0.8, [2.88, 22.26, -207.64, 1034.30]),
        (-5.0, [2.88, 21.81, -258.11, -858.36]),
        (-12.0, [2.70, 12.17, -431.69, -1899.83]),
        (-18.0, [13.84, 262.72, 1447.42, 2797.93]),
    ];
    let held = degrees.clamp(-18.0, 90.0);
    let (_, cubic) = STRETCHES.iter().find(|(from, _)| held >= *from).unwrap_or(&STRETCHES[5]);
    let x = held / 90.0;
    let logarithm: f64 = cubic.iter().enumerate().map(|(power, part)| part * x.powi(power as i32)).sum();
    10.0_f64.powf(logarithm)
}
