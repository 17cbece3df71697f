//! The moon's phases.

/// Unit vector toward azimuth and elevation (rad): east, up, south.
fn toward([azimuth, elevation]: [f64; 2]) -> [f64; 3] {
    [elevation.cos() * azimuth.sin(), elevation.sin(), -elevation.cos() * azimuth.cos()]
}

/// Angle at the moon between sun and eye (rad), the sun being far beyond the moon; each by azimuth and elevation (rad).
#[must_use]
pub fn phase_angle(moon: [f64; 2], sun: [f64; 2]) -> f64 {
    let (m, s) = (toward(moon), toward(sun));
    let cosine: f64 = (0..3).map(|i| m[i] * s[i]).sum();
    let cross = [m[1] * s[2] - m[2] * s[1], m[2] * s[0] - m[0] * s[2], m[0] * s[1] - m[1] * s[0]];
    let sine = cross.iter().map(|part| part * part).sum::<f64>().sqrt();
    sine.atan2(-cosine)
}

/// Light of the moon over the full moon's at `angle` (rad): magnitudes .026 a + 4e-9 a⁴, a in degrees (Allen 1976).
#[must_use]
pub fn phase_law(angle: f64) -> f64 {
    let degrees = angle.to_degrees();
    10.0_f64.powf(-0.4 * (0.026 * degrees + 4e-9 * degrees.powi(4)))
}

/// Places of the moon's disc on a grid of `side`², as cosines between the normal and sun and eye; and how many there are. The
/// sun stands at the phase angle `angle` (rad) to the right.
#[must_use]
pub fn disc(side: u32, angle: f64) -> (Vec<[f64; 2]>, f64) {
    let mut places = Vec::new();
    let along = |i: u32| (f64::from(i) + 0.5) / f64::from(side) * 2.0 - 1.0;
    for i in 0..side {
        for j in 0..side {
            let (x, y) = (along(i), along(j));
            let toward_eye = 1.0 - x * x - y * y;
            if toward_eye > 0.0 {
                let eye = toward_eye.sqrt();
                places.push([x * angle.sin() + eye * angle.cos(), eye]);
            }
        }
    }
    let count = places.len() as f64;
    (places, count)
}
