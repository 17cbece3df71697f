//! What clouds are made of: puffs, profiles over height, and how steep noise can be.

use crate::hash::pcg;

/// Round heaps around the points of the lattice, each displaced by up to .3 along each axis: the largest of
/// 1 - (distance / .7)² over *all* of them within two cells, at least 0.
#[must_use]
pub fn puff3(p: [f64; 3], seed: u32) -> f64 {
    let home = p.map(f64::floor);
    let mut best = 0.0_f64;
    for step in 0..125 {
        let at = [step % 5 - 2, step / 5 % 5 - 2, step / 25 - 2];
        let point: [f64; 3] = std::array::from_fn(|axis| home[axis] + f64::from(at[axis]));
        let cell = point.map(|c| c as i64 as u32);
        let row = pcg(cell[1].wrapping_add(pcg(cell[2].wrapping_add(pcg(seed)))));
        let bytes = pcg(cell[0].wrapping_add(row)).to_be_bytes();
        let square: f64 = (0..3)
            .map(|axis| point[axis] + 0.3 * (f64::from(bytes[axis]) / 127.5 - 1.0) - p[axis])
            .map(|d| d * d)
            .sum();
        best = best.max(1.0 - square / 0.49);
    }
    best
}

/// The trapezoid through (a, 0), (b, 1), (c, 1), (d, 0).
#[must_use]
pub fn trapezoid(x: f64, [a, b, c, d]: [f64; 4]) -> f64 {
    if x <= a || x >= d {
        0.0
    } else if x < b {
        (x - a) / (b - a)
    } else if x <= c {
        1.0
    } else {
        (d - x) / (d - c)
    }
}

/// Profiles of stratus, stratocumulus and cumulus, blended by a type 0 .. 1.
#[must_use]
pub fn stops(kind: f64) -> [f64; 4] {
    const TYPES: [[f64; 4]; 3] = [[0.0, 0.1, 0.2, 0.3], [0.02, 0.2, 0.48, 0.625], [0.01, 0.0625, 0.78, 1.0]];
    let (low, part) = if kind < 0.5 { (0, 2.0 * kind) } else { (1, 2.0 * kind - 1.0) };
    std::array::from_fn(|i| TYPES[low][i] + part * (TYPES[low + 1][i] - TYPES[low][i]))
}

/// The greatest slope that Perlin noise in space (scaled by .9645) can have at `at` of its cell along the unit
/// `toward`, over all gradients that the corners may have: each corner's part is linear in its gradient, so each
/// takes its best.
#[must_use]
pub fn perlin3_slope(at: [f64; 3], toward: [f64; 3]) -> f64 {
    let fade = at.map(|t| t * t * t * (t * (6.0 * t - 15.0) + 10.0));
    let slope = at.map(|t| 30.0 * t * t * (t - 1.0) * (t - 1.0));
    let mut sum = 0.0;
    for corner in 0..8 {
        let is_high: [bool; 3] = std::array::from_fn(|axis| corner >> axis & 1 == 1);
        let weight: [f64; 3] = std::array::from_fn(|i| if is_high[i] { fade[i] } else { 1.0 - fade[i] });
        let change: [f64; 3] = std::array::from_fn(|i| if is_high[i] { slope[i] } else { -slope[i] });
        let whole = weight[0] * weight[1] * weight[2];
        let turning = change[0] * weight[1] * weight[2] * toward[0]
            + weight[0] * change[1] * weight[2] * toward[1]
            + weight[0] * weight[1] * change[2] * toward[2];
        let pull: [f64; 3] =
            std::array::from_fn(|i| whole * toward[i] + turning * (at[i] - f64::from(u8::from(is_high[i]))));
        // The best of (±1, ±1, 0) and its like: the two largest coordinates, each by its sign.
        let mut sizes = pull.map(f64::abs);
        sizes.sort_by(f64::total_cmp);
        sum += sizes[1] + sizes[2];
    }
    0.9645 * sum
}
