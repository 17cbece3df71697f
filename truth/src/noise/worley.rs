//! Worley noise by brute force.

use super::{Period, dot, point_hash};
use crate::hash::{pcg, unit};

/// The nearest feature points.
#[derive(Debug, Clone, Copy)]
pub struct Worley<const N: usize> {
    /// Distance to the nearest.
    pub f1: f64,
    /// Distance to the second nearest.
    pub f2: f64,
    /// From the place to the nearest.
    pub offset: [f64; N],
    /// Hash of the nearest one's cell.
    pub id: u32,
}

/// The nearest feature points in the plane.
#[must_use]
pub fn worley2(p: [f64; 2], period: Period<2>, seed: u32) -> Worley<2> {
    worley(p, period, seed)
}

/// The nearest feature points in space.
#[must_use]
pub fn worley3(p: [f64; 3], period: Period<3>, seed: u32) -> Worley<3> {
    worley(p, period, seed)
}

/// The nearest feature points of 5 × 5 (× 5) cells: no second nearest is more than √3 away, all others are at least 2.
fn worley<const N: usize>(p: [f64; N], period: Period<N>, seed: u32) -> Worley<N> {
    let period = period.map(|period| period.map(i64::from));
    let mut found = Worley { f1: f64::INFINITY, f2: f64::INFINITY, offset: [0.0; N], id: 0 };
    for neighbour in 0..5_i64.pow(N as u32) {
        let cell: [i64; N] =
            std::array::from_fn(|axis| p[axis].floor() as i64 + neighbour / 5_i64.pow(axis as u32) % 5 - 2);
        let id = point_hash(cell, period, seed);
        let mut hash = id;
        let offset = std::array::from_fn(|axis| {
            let inside = unit(hash);
            hash = pcg(hash);
            cell[axis] as f64 + inside - p[axis]
        });
        let distance = dot(offset, offset).sqrt();
        if distance < found.f1 {
            found = Worley { f1: distance, f2: found.f1, offset, id };
        } else {
            found.f2 = found.f2.min(distance);
        }
    }
    found
}
