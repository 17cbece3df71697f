//! Simplex noise: each lattice point's ramp under its kernel, (1/2 - r²)⁴ within r² = 1/2.

use super::{Period, direction2, direction3, dot, point_hash};

/// Simplex noise of the plane: √(3/2) points a unit along x in √2 rows a unit along y, every other row half a step on;
/// with a period, the nearest whole numbers of points and of pairs of rows that fill it.
pub fn simplex2(p: [f64; 2], period: Period<2>, seed: u32) -> f64 {
    let spacing = [(2.0_f64 / 3.0).sqrt(), 0.5_f64.sqrt()];
    let counts = period.map(|[x, y]| {
        // In f32, as the period's own digits are on the GPU.
        let columns = i64::from(x) + (x as f32 * 0.224_744_87).round_ties_even() as i64;
        let rows = 2 * ((y as f32 * 0.707_106_77).round_ties_even() as i64).max(1);
        [columns, rows]
    });
    let density = match (period, counts) {
        (Some(period), Some(counts)) => [0, 1].map(|axis| counts[axis] as f64 / f64::from(period[axis])),
        _ => [1.5_f64.sqrt(), 2.0_f64.sqrt()],
    };
    let period = counts.map(|[columns, rows]| [2 * columns, rows]);
    // Everything in lattice steps and rows.
    let place = [p[0] * density[0], p[1] * density[1]];
    let first_row = place[1].floor() as i64 - 1;
    let mut sum = 0.0;
    for row in first_row..first_row + 4 {
        let shift = row.rem_euclid(2);
        let first = (place[0] - 0.5 * shift as f64).floor() as i64 - 1;
        for step in first..first + 4 {
            let half_steps = 2 * step + shift;
            let offset =
                [(place[0] - 0.5 * half_steps as f64) * spacing[0], (place[1] - row as f64) * spacing[1]];
            let kernel = 0.5 - dot(offset, offset);
            if kernel > 0.0 {
                let hash = point_hash([half_steps, row], period, seed);
                sum += kernel.powi(4) * dot(direction2(hash), offset);
            }
        }
    }
    98.0 * sum
}

/// Simplex noise of space, its points those of the integers and the middles of their cubes.
pub fn simplex3(p: [f64; 3], period: Period<3>, seed: u32) -> f64 {
    let period = period.map(|period| period.map(|count| 2 * i64::from(count)));
    let low = p.map(|x| x.floor() as i64);
    let mut sum = 0.0;
    for half in 0..2 {
        for neighbour in 0..27 {
            let step = [neighbour % 3, neighbour / 3 % 3, neighbour / 9];
            let twice: [i64; 3] = std::array::from_fn(|axis| 2 * (low[axis] + step[axis] - 1 + half) - half);
            let offset: [f64; 3] = std::array::from_fn(|axis| p[axis] - 0.5 * twice[axis] as f64);
            let kernel = 0.5 - dot(offset, offset);
            if kernel > 0.0 {
                sum += kernel.powi(4) * dot(direction3(point_hash(twice, period, seed)), offset);
            }
        }
    }
    76.0 * sum
}
