//! Value and Perlin noise: what the corners of a cell say, weighted by the quintic fade.

use super::{PERLIN2_SCALE, Period, direction2, direction3, dot, point_hash};
use crate::hash::signed;

/// Value noise of the plane.
pub fn value2(p: [f64; 2], period: Period<2>, seed: u32) -> f64 {
    value(p, period, seed)
}

/// Value noise of space.
pub fn value3(p: [f64; 3], period: Period<3>, seed: u32) -> f64 {
    value(p, period, seed)
}

fn value<const N: usize>(p: [f64; N], period: Period<N>, seed: u32) -> f64 {
    blend(p.map(|x| x.floor() as i64), p.map(|x| x - x.floor()), period, seed, |hash, _| signed(hash))
}

/// Perlin noise of the plane.
pub fn perlin2(p: [f64; 2], period: Period<2>, seed: u32) -> f64 {
    let ramp = |hash, offset| dot(direction2(hash), offset);
    PERLIN2_SCALE * blend(p.map(|x| x.floor() as i64), p.map(|x| x - x.floor()), period, seed, ramp)
}

/// Perlin noise of space.
pub fn perlin3(p: [f64; 3], period: Period<3>, seed: u32) -> f64 {
    perlin3_at(p.map(|x| x.floor() as i64), p.map(|x| x - x.floor()), period, seed)
}

/// Perlin noise of space at `cell + fraction`.
pub fn perlin3_at(cell: [i64; 3], fraction: [f64; 3], period: Period<3>, seed: u32) -> f64 {
    let cell = std::array::from_fn(|axis| cell[axis] + fraction[axis].floor() as i64);
    let ramp = |hash, offset| dot(direction3(hash), offset);
    0.9645 * blend(cell, fraction.map(|x| x - x.floor()), period, seed, ramp)
}

/// The mean over the corners of `cell` of what each `says` of its hash and its offset to `t`, by the fade's weights.
fn blend<const N: usize>(
    cell: [i64; N],
    t: [f64; N],
    period: Period<N>,
    seed: u32,
    says: impl Fn(u32, [f64; N]) -> f64,
) -> f64 {
    let period = period.map(|period| period.map(i64::from));
    (0..1 << N)
        .map(|corner: i64| {
            let side: [i64; N] = std::array::from_fn(|axis| corner >> axis & 1);
            let weight: f64 = (0..N)
                .map(|axis| {
                    let x = t[axis];
                    let fade = 6.0 * x.powi(5) - 15.0 * x.powi(4) + 10.0 * x.powi(3);
                    if side[axis] == 1 { fade } else { 1.0 - fade }
                })
                .product();
            let point = std::array::from_fn(|axis| cell[axis] + side[axis]);
            let offset = std::array::from_fn(|axis| t[axis] - side[axis] as f64);
            weight * says(point_hash(point, period, seed), offset)
        })
        .sum()
}
