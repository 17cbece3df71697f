//! Noises of the plane (`N` = 2) and of space (`N` = 3), endless or repeating with a period.
//!
//! Each is the sum over the lattice points that reach a place, whichever they are: nothing here knows how the GPU finds them.

pub mod bounds;
mod compounds;
mod interleaved_gradient;
mod lattice;
mod simplex;
mod worley;

pub use compounds::{curl2, curl3, perlin_worley3};
pub use interleaved_gradient::interleaved_gradient;
pub use lattice::{perlin2, perlin3, perlin3_at, value2, value3};
pub use simplex::{simplex2, simplex3};
pub use worley::{Worley, worley2, worley3};

use crate::hash::{pcg, signed};

/// How often a noise repeats along each axis; `None`: never.
pub type Period<const N: usize> = Option<[u32; N]>;

/// What Perlin noise of the plane is multiplied by, to stay within -1 … 1.
#[allow(
    clippy::approx_constant,
    reason = "rounded down, so that rounding of the noise leaves no value above 1"
)]
const PERLIN2_SCALE: f64 = 1.4142;

/// tan(u π/4) ≈ a u + b u³ + c u⁵.
#[allow(clippy::approx_constant, reason = "a fit over -1 … 1, not the series")]
const TANGENT: [f64; 3] = [0.78540, 0.16149, 0.05311];

/// Hash of a lattice point, the last coordinate hashed first. `period` counts in units of `point`.
fn point_hash<const N: usize>(point: [i64; N], period: Option<[i64; N]>, seed: u32) -> u32 {
    (0..N).rev().fold(pcg(seed), |hash, axis| {
        let index = period.map_or(point[axis], |period| point[axis].rem_euclid(period[axis]));
        pcg((index as u32).wrapping_add(hash))
    })
}

/// The unit vector of a lattice point of the plane: half of the circle by the top bit, the angle's tangent by a polynomial.
fn direction2(hash: u32) -> [f64; 2] {
    let u = signed(hash << 1);
    let tangent = TANGENT[0] * u + TANGENT[1] * u.powi(3) + TANGENT[2] * u.powi(5);
    let angle = 2.0 * tangent.atan() + if hash >> 31 == 1 { std::f64::consts::PI } else { 0.0 };
    [angle.cos(), angle.sin()]
}

/// One of the twelve edges of the cube, by the top four bits as in Perlin's own table of 2002.
fn direction3(hash: u32) -> [f64; 3] {
    const EDGES: [[f64; 3]; 16] = [
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
        [1.0, -1.0, 0.0],
        [-1.0, -1.0, 0.0],
        [1.0, 0.0, 1.0],
        [-1.0, 0.0, 1.0],
        [1.0, 0.0, -1.0],
        [-1.0, 0.0, -1.0],
        [0.0, 1.0, 1.0],
        [0.0, -1.0, 1.0],
        [0.0, 1.0, -1.0],
        [0.0, -1.0, -1.0],
        [1.0, 1.0, 0.0],
        [0.0, -1.0, 1.0],
        [-1.0, 1.0, 0.0],
        [0.0, -1.0, -1.0],
    ];
    EDGES[(hash >> 28) as usize]
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    (0..N).map(|axis| a[axis] * b[axis]).sum()
}

/// (d/dx, …) of `f` at `p`, by central differences over ± `step`.
pub fn gradient<const N: usize>(f: impl Fn([f64; N]) -> f64, p: [f64; N], step: f64) -> [f64; N] {
    std::array::from_fn(|axis| {
        let moved = |by: f64| {
            let mut q = p;
            q[axis] += by;
            f(q)
        };
        (moved(step) - moved(-step)) / (2.0 * step)
    })
}

/// (d²/dx², d²/dxdy, d²/dy²) of `f` at `p`, by central differences over ± `step`.
pub fn hessian(f: impl Fn([f64; 2]) -> f64, [x, y]: [f64; 2], step: f64) -> [f64; 3] {
    let at = |i: f64, j: f64| f([x + i * step, y + j * step]);
    let middle = 2.0 * at(0.0, 0.0);
    let square = step * step;
    [
        (at(1.0, 0.0) - middle + at(-1.0, 0.0)) / square,
        (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * square),
        (at(0.0, 1.0) - middle + at(0.0, -1.0)) / square,
    ]
}
