//! Interleaved gradient noise (Jimenez 2014).

/// fract(52.98 fract(a x + b y)) of whole pixels, moved on by 5.588238 pixels a frame both ways; `nudge` is added to the
/// inner sum.
#[must_use]
pub fn interleaved_gradient([x, y]: [f64; 2], frame: u32, nudge: f64) -> f64 {
    let shift = 5.588_238 * f64::from(frame);
    let inner = 0.067_110_56 * (x.floor() + shift) + 0.005_837_15 * (y.floor() + shift) + nudge;
    (52.982_918_9 * inner.rem_euclid(1.0)).rem_euclid(1.0)
}
