//! Where functions are looked at: the same points in every run.

use crate::hash::{pcg, pcg2d, pcg3d, signed};

/// A stream of uniformly distributed numbers.
#[derive(Debug, Clone)]
pub struct Random {
    state: u32,
}

impl Random {
    /// Another `seed`, another stream.
    #[must_use]
    pub fn new(seed: u32) -> Self {
        Self { state: pcg(seed) }
    }

    /// 32 random bits.
    pub fn bits(&mut self) -> u32 {
        self.state = self.state.wrapping_add(0x9E37_79B9);
        pcg(pcg(self.state))
    }

    /// A number in `low .. high`, an `f32` to the last bit.
    pub fn within(&mut self, low: f32, high: f32) -> f32 {
        let part = self.bits() as f32 / 4_294_967_296.0;
        low + part * (high - low)
    }

    /// A point of `N` coordinates, each in `-reach .. reach`.
    pub fn point<const N: usize>(&mut self, reach: f32) -> [f32; N] {
        std::array::from_fn(|_| self.within(-reach, reach))
    }

    /// So many points, each coordinate in `-reach .. reach`.
    pub fn points<const N: usize>(&mut self, count: usize, reach: f32) -> Vec<[f32; N]> {
        (0..count).map(|_| self.point(reach)).collect()
    }
}

/// Place number `index` of an endless list in the plane, each coordinate in `-reach .. reach`: the tests walk it on the GPU too,
/// as `(unit_float2(pcg2d(vec2u(index, 77u))) * 2.0 - 1.0) * reach`.
#[must_use]
pub fn place2(index: u32, reach: f32) -> [f32; 2] {
    pcg2d([index, 77]).map(|bits| signed(bits) as f32 * reach)
}

/// As [`place2`], in space: of `pcg3d(vec3u(index, 77u, 78u))`.
#[must_use]
pub fn place3(index: u32, reach: f32) -> [f32; 3] {
    pcg3d([index, 77, 78]).map(|bits| signed(bits) as f32 * reach)
}

/// How far the worst of `found` is from `truth` of its place; infinitely far if one is NaN.
pub fn worst2(found: &[f64], reach: f32, truth: &dyn Fn(u32, [f64; 2]) -> f64) -> f64 {
    worst(found, |index| truth(index, place2(index, reach).map(f64::from)))
}

/// As [`worst2`], in space.
pub fn worst3(found: &[f64], reach: f32, truth: &dyn Fn(u32, [f64; 3]) -> f64) -> f64 {
    worst(found, |index| truth(index, place3(index, reach).map(f64::from)))
}

fn worst(found: &[f64], truth: impl Fn(u32) -> f64) -> f64 {
    let errors = found.iter().zip(0..).map(|(found, index)| (found - truth(index)).abs());
    errors.fold(0.0, |most, error| if error.is_nan() { f64::INFINITY } else { f64::max(most, error) })
}
