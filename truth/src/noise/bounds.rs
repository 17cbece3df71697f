//! The largest value, slope and curvature that a noise of the plane can have, over all that its hashes can be.
//!
//! At one place and along one direction each of the three is a sum over lattice points of something linear in what the point
//! was dealt (a unit vector g, or a number v of -1 … 1). So its maximum over all deals is the sum of norms, |Σ g·a| ≤ Σ |a|, and what
//! is left to search is two coordinates and one angle. The norms are convex in the point's deal, so they are attained.

/// [value, slope, curvature] that the deals can reach at (x, y) of a cell, the two latter along a direction.
pub type Reach = fn([f64; 3]) -> [f64; 3];

/// (weight, its first, its second derivative) of one side of a cell at `t`.
fn fade(t: f64, far: bool) -> [f64; 3] {
    let value = 6.0 * t.powi(5) - 15.0 * t.powi(4) + 10.0 * t.powi(3);
    let slope = 30.0 * t.powi(4) - 60.0 * t.powi(3) + 30.0 * t * t;
    let curvature = 120.0 * t.powi(3) - 180.0 * t * t + 60.0 * t;
    if far { [value, slope, curvature] } else { [1.0 - value, -slope, -curvature] }
}

/// A cell's corners: offset to the place, and weight with its first and second derivative along `angle`.
fn corners([x, y, angle]: [f64; 3]) -> impl Iterator<Item = ([f64; 2], [f64; 3])> {
    let (b, a) = angle.sin_cos();
    [(false, false), (true, false), (false, true), (true, true)].into_iter().map(move |(right, up)| {
        let (u, v) = (fade(x, right), fade(y, up));
        let slope = u[1] * v[0] * a + u[0] * v[1] * b;
        let curvature = u[2] * v[0] * a * a + 2.0 * u[1] * v[1] * a * b + u[0] * v[2] * b * b;
        let offset = [x - f64::from(u8::from(right)), y - f64::from(u8::from(up))];
        (offset, [u[0] * v[0], slope, curvature])
    })
}

/// Of value noise.
#[must_use]
pub fn value(at: [f64; 3]) -> [f64; 3] {
    corners(at).fold([0.0; 3], |sum, (_, weight)| [0, 1, 2].map(|order| sum[order] + weight[order].abs()))
}

/// Of Perlin noise.
#[must_use]
pub fn perlin(at: [f64; 3]) -> [f64; 3] {
    let (b, a) = at[2].sin_cos();
    let sum = corners(at).fold([0.0; 3], |sum, ([x, y], [w, dw, ddw])| {
        [
            sum[0] + (w * x).hypot(w * y),
            sum[1] + (w * a + dw * x).hypot(w * b + dw * y),
            sum[2] + (2.0 * dw * a + ddw * x).hypot(2.0 * dw * b + ddw * y),
        ]
    });
    sum.map(|reach| super::PERLIN2_SCALE * reach)
}

/// Of simplex noise; (x, y) are slanted coordinates of one triangle, mirrored into it.
#[must_use]
pub fn simplex([x, y, angle]: [f64; 3]) -> [f64; 3] {
    let (x, y) = if x + y > 1.0 { (1.0 - x, 1.0 - y) } else { (x, y) };
    let (b, a) = angle.sin_cos();
    let mut sum = [0.0; 3];
    for (i, j) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)] {
        let dx = (x - i + 0.5 * (y - j)) * (2.0_f64 / 3.0).sqrt();
        let dy = (y - j) * 0.5_f64.sqrt();
        let along = dx * a + dy * b;
        let k = (0.5 - dx * dx - dy * dy).max(0.0);
        // (1/2 - r²)⁴ d, differentiated along the direction once and twice.
        let slope = |e: f64, d: f64| k.powi(4) * e - 8.0 * k.powi(3) * along * d;
        let curvature = |e: f64, d: f64| {
            (48.0 * k * k * along * along - 8.0 * k.powi(3)) * d - 16.0 * k.powi(3) * along * e
        };
        sum[0] += k.powi(4) * dx.hypot(dy);
        sum[1] += slope(a, dx).hypot(slope(b, dy));
        sum[2] += curvature(a, dx).hypot(curvature(b, dy));
    }
    sum.map(|reach| 98.0 * reach)
}

/// The largest value that Perlin noise of space can have at a place of a cell.
#[must_use]
pub fn perlin3(at: [f64; 3]) -> f64 {
    let sum: f64 = (0..8)
        .map(|corner| {
            let mut weight = 1.0;
            let offset = [0, 1, 2].map(|axis| {
                let far = corner >> axis & 1 == 1;
                weight *= fade(at[axis], far)[0];
                at[axis] - f64::from(u8::from(far))
            });
            weight * best_edge(offset)
        })
        .sum();
    0.9645 * sum
}

/// The steepest that Perlin noise of space can be along x at a place of a cell; y and z are no different.
#[must_use]
pub fn perlin3_along_x(at: [f64; 3]) -> f64 {
    let sum: f64 = (0..8)
        .map(|corner| {
            let mut sides = [[0.0; 3]; 3];
            let offset: [f64; 3] = std::array::from_fn(|axis| {
                let far = corner >> axis & 1 == 1;
                sides[axis] = fade(at[axis], far);
                at[axis] - f64::from(u8::from(far))
            });
            let across = sides[1][0] * sides[2][0];
            // The derivative of weight times g·offset, as a vector that g is multiplied with.
            let steepened = offset.map(|part| part * sides[0][1] * across);
            best_edge([steepened[0] + sides[0][0] * across, steepened[1], steepened[2]])
        })
        .sum();
    0.9645 * sum
}

/// The largest value that simplex noise of space can have at a place of a cube of its lattice.
#[must_use]
pub fn simplex3(at: [f64; 3]) -> f64 {
    let mut sum = 0.0;
    for half in [0.0, 0.5] {
        for neighbour in 0..27 {
            let step = [neighbour % 3, neighbour / 3 % 3, neighbour / 9];
            let offset = [0, 1, 2].map(|axis| at[axis] + half - f64::from(step[axis]));
            let kernel = 0.5 - super::dot(offset, offset);
            sum += kernel.max(0.0).powi(4) * best_edge(offset);
        }
    }
    76.0 * sum
}

/// The largest product of `offset` with an edge of the cube: its two largest coordinates.
fn best_edge(offset: [f64; 3]) -> f64 {
    let [x, y, z] = offset.map(f64::abs);
    x + y + z - x.min(y).min(z)
}

/// The largest `f` over 0 … 1, 0 … 1, 0 … `depth`: over a grid, then over ever finer ones around the best places.
pub fn largest(f: impl Fn([f64; 3]) -> f64, depth: f64) -> f64 {
    const GRID: i32 = 48;
    let mut found: Vec<(f64, [f64; 3])> = Vec::new();
    for i in 0..=GRID {
        for j in 0..=GRID {
            for k in 0..=GRID {
                let at = [i, j, k].map(|index| f64::from(index) / f64::from(GRID));
                let at = [at[0], at[1], at[2] * depth];
                found.push((f(at), at));
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found
        .iter()
        .take(64)
        .map(|&(value, at)| climb(&f, value, at, 1.0 / f64::from(GRID), depth))
        .fold(0.0, f64::max)
}

/// Uphill from `at`, in steps that halve once no neighbour is higher.
fn climb(f: &impl Fn([f64; 3]) -> f64, value: f64, at: [f64; 3], step: f64, depth: f64) -> f64 {
    let (mut value, mut at, mut step) = (value, at, step);
    while step > 1e-9 {
        let neighbours = (0..27).map(|neighbour| {
            let way = [neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1].map(f64::from);
            [
                (at[0] + step * way[0]).clamp(0.0, 1.0),
                (at[1] + step * way[1]).clamp(0.0, 1.0),
                (at[2] + step * way[2]).clamp(0.0, depth),
            ]
        });
        match neighbours.map(|next| (f(next), next)).max_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((higher, next)) if higher > value => (value, at) = (higher, next),
            _ => step *= 0.5,
        }
    }
    value
}
