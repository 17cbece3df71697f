//! What is made of other noises.

use super::{gradient, perlin2, perlin3, worley3};
use crate::hash::pcg;

/// The step of the differences that stand for derivatives here; exact to about 1e-9 of them.
const STEP: f64 = 1e-5;

/// Perlin–Worley noise: `remap(perlin, 0, 1, worley, 1)` of three octaves each.
#[must_use]
pub fn perlin_worley3(p: [f64; 3], period: [u32; 3], seed: u32) -> f64 {
    let octaves = [1_u32, 2, 4].into_iter().zip(seed..).map(|(scale, seed)| {
        let q = p.map(|x| x * f64::from(scale));
        let period = period.map(|count| count * scale);
        let billow = 1.0 - worley3(q, Some(period), seed).f1 / 3.0_f64.sqrt();
        (perlin3(q, Some(period), seed), billow)
    });
    let (perlin, billows): (Vec<f64>, Vec<f64>) = octaves.unzip();
    let perlin = (perlin[0] + perlin[1] / 2.0 + perlin[2] / 4.0) / 1.75;
    let worley = 0.625 * billows[0] + 0.25 * billows[1] + 0.125 * billows[2];
    worley + (1.0 - worley) * (0.5 + 0.5 * perlin)
}

/// Curl noise of the plane: (∂n/∂y, −∂n/∂x).
#[must_use]
pub fn curl2(p: [f64; 2], seed: u32) -> [f64; 2] {
    let [x, y] = gradient(|p| perlin2(p, None, seed), p, STEP);
    [y, -x]
}

/// Curl noise of space: ∇ × (n₀, n₁, n₂).
#[must_use]
pub fn curl3(p: [f64; 3], seed: u32) -> [f64; 3] {
    let [a, b, c] = [0, 1, 2].map(|i| gradient(|p| perlin3(p, None, pcg(seed).wrapping_add(i)), p, STEP));
    [c[1] - b[2], a[2] - c[0], b[0] - a[1]]
}
