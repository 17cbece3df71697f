//! A square of the map, in whole millimetres → the places of its samples, which neighbours share to the last bit.
//!
//! A place is a fraction of whole numbers, rounded once: whoever comes to the same place, from the left or from the right,
//! with many samples or with few, comes to the same f32.

use super::error::HeightmapError;

/// A square of the map that is sampled on a grid, from edge to edge: its last column is its eastern neighbour's first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    /// The north-western sample: east and south (x and z), in mm.
    pub origin: [i64; 2],
    /// From the first sample to the last, each way, in mm.
    pub size: u64,
    /// Samples each way.
    pub pixels: u32,
}

/// The most samples each way: 1 GiB of heights.
pub const MOST_PIXELS: u32 = 16_385;
/// As far from the world's origin as a tile may reach, in mm.
const FARTHEST: i64 = 1_000_000_000_000;

impl Tile {
    /// From one sample to the next (m).
    pub fn spacing(&self) -> f64 {
        self.size as f64 / 1000.0 / f64::from(self.pixels.max(2) - 1)
    }

    /// Where the sample numbered `index` along an axis is (m): 0 is east, from the western edge; 1 south, from the northern.
    pub fn position(&self, axis: usize, index: u32) -> f32 {
        let intervals = i128::from(self.pixels.max(2) - 1);
        let numerator = i128::from(self.origin[axis]) * intervals + i128::from(index) * i128::from(self.size);
        let denominator = 1000 * intervals;
        // Both parts of the quotient are numbers that f64 holds: equal fractions give equal bits.
        let whole = numerator.div_euclid(denominator) as f64;
        let rest = numerator.rem_euclid(denominator) as f64;
        (whole + rest / denominator as f64) as f32
    }

    /// Sees to it that there is something to sample, and that f32 can tell its samples apart.
    pub(super) fn check(&self) -> Result<(), HeightmapError> {
        let fault = |why: String, help| Err(HeightmapError::Tile { why, help });
        if !(2..=MOST_PIXELS).contains(&self.pixels) {
            let why = format!("a tile has 2 to {MOST_PIXELS} samples each way, and not {}", self.pixels);
            return fault(why, "one more than a power of two suits most engines: `--pixels 1025`");
        }
        if self.size == 0 || self.size > FARTHEST as u64 {
            let why = format!("a tile cannot be {} m wide", self.size as f64 / 1000.0);
            return fault(why, "give it in metres, as in `--size 2048`");
        }
        if self.origin.iter().any(|at| at.unsigned_abs() > FARTHEST as u64) {
            return fault(
                "the tile lies farther out than 1,000,000 km".into(),
                "give its north-western corner in metres",
            );
        }
        let ends = [0, self.pixels - 1];
        let places = [0, 1].into_iter().flat_map(|axis| ends.map(|end| self.position(axis, end).abs()));
        let farthest = places.fold(0.0, f32::max);
        let digit = farthest.next_up() - farthest;
        if self.spacing() < 4.0 * f64::from(digit) {
            return Err(HeightmapError::TooFar { at: farthest, digit, spacing: self.spacing() });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_edges_are_where_they_were_asked_for() {
        let tile = Tile { origin: [-1500, 250], size: 3000, pixels: 4 };
        assert_eq!([0, 1, 2, 3].map(|index| tile.position(0, index)), [-1.5, -0.5, 0.5, 1.5]);
        assert_eq!(tile.position(1, 3), 3.25);
        assert_eq!(tile.spacing(), 1.0);
    }

    proptest! {
        #[test]
        fn neighbours_share_their_edges_to_the_last_bit(
            origin in -1_000_000_000_i64..1_000_000_000,
            size in 1_u64..100_000_000,
            pixels in 2_u32..5000,
            of_neighbour in 2_u32..5000,
        ) {
            let tile = Tile { origin: [origin; 2], size, pixels };
            let east = Tile { origin: [origin + size as i64, origin], size, pixels: of_neighbour };
            prop_assert_eq!(tile.position(0, pixels - 1).to_bits(), east.position(0, 0).to_bits());
            let west = Tile { origin: [origin - size as i64, origin], size, pixels: of_neighbour };
            prop_assert_eq!(west.position(0, of_neighbour - 1).to_bits(), tile.position(0, 0).to_bits());
        }

        #[test]
        fn twice_the_samples_keep_every_sample_of_half_as_many(
            origin in -1_000_000_000_i64..1_000_000_000,
            size in 1_u64..100_000_000,
            intervals in 1_u32..2000,
            index in 0_u32..2000,
        ) {
            let few = Tile { origin: [origin; 2], size, pixels: intervals + 1 };
            let many = Tile { pixels: 2 * intervals + 1, ..few };
            let index = index.min(intervals);
            prop_assert_eq!(few.position(1, index).to_bits(), many.position(1, 2 * index).to_bits());
        }
    }
}
