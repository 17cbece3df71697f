//! A planet's ground, in f64 from its definition: one map of heights on three planes, and rays that meet it.
//!
//! f64 knows a place at Earth's radius to a billionth of a metre: there are no cells and fractions here.

use crate::hash::{pcg, pcg2d, unit};
use crate::noise::perlin2;

/// What a planet is made of, as `planet.*` calls it; heights in m.
#[derive(Debug, Clone, Copy)]
pub struct Planet {
    /// `sky.ground_radius`
    pub radius: f64,
    /// The planet's own axes as columns: the world's east, up and south.
    pub axes: [[f64; 3]; 3],
    /// The world's origin in the planet's own axes (m).
    pub origin: [f64; 3],
    /// `planet.relief`
    pub relief: Relief,
    /// `planet.seed`
    pub seed: u32,
    /// `planet.scale`
    pub scale: f64,
    /// `planet.octaves`
    pub octaves: u32,
    /// `planet.peak_height`
    pub peak_height: f64,
    /// `planet.swell`
    pub swell: f64,
    /// `planet.bend`
    pub bend: f64,
    /// `planet.gain`
    pub gain: f64,
    /// `planet.sharpness`
    pub sharpness: f64,
    /// `planet.sides`
    pub sides: [f64; 2],
}

/// The two kinds of ground, and what only they have.
#[derive(Debug, Clone, Copy)]
pub enum Relief {
    /// Normal quantile of `planet.ocean`, `planet.sea_floor`, `planet.chains`, `planet.hills`
    Continents(f64, f64, f64, f64),
    /// `planet.craters`, `planet.crater_depth`, `planet.crater_coarsest`
    Craters(f64, f64, u32),
}

/// What 68 % of the standard normal distribution lie below: of the default of `planet.ocean`.
pub const QUANTILE_68: f64 = 0.467_698_799_114_508;

/// An earth, as the library's defaults have it but for a grain of one metre.
pub const EARTH: Planet = Planet {
    radius: 6_360_000.0,
    axes: [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
    origin: [6_360_000.0, 0.0, 0.0],
    relief: Relief::Continents(QUANTILE_68, 3800.0, 0.16, 0.10),
    seed: 1,
    scale: 4_194_304.0,
    octaves: 22,
    peak_height: 8000.0,
    swell: 1500.0,
    bend: 0.15,
    gain: 0.52,
    sharpness: 6.0,
    sides: [31e6, 17e6],
};

/// A mars.
pub const MARS: Planet = Planet {
    radius: 3_389_500.0,
    relief: Relief::Craters(0.45, 0.7, 3),
    seed: 4,
    scale: 2_097_152.0,
    octaves: 21,
    peak_height: 1800.0,
    swell: 2500.0,
    ..EARTH
};

impl Planet {
    /// (unit vector upward in the world, height above sea level) of `p` of the world.
    pub fn place(&self, p: [f64; 3]) -> ([f64; 3], f64) {
        let out = [p[0], p[1] + self.radius, p[2]];
        let length = out.iter().map(|x| x * x).sum::<f64>().sqrt();
        (out.map(|x| x / length), length - self.radius)
    }

    /// `v` of the world in the planet's own axes.
    fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|row| (0..3).map(|column| self.axes[column][row] * v[column]).sum())
    }

    /// Height of the ground (m) beneath `p` of the world, octaves below level `finest` left out.
    pub fn height(&self, p: [f64; 3], finest: f64) -> f64 {
        let (up, altitude) = self.place(p);
        let beneath = self.turned(std::array::from_fn(|axis| p[axis] - altitude * up[axis]));
        let weights = weights(self.turned(up), self.sharpness);
        let grain = self.scale / f64::from(1_u32 << self.octaves);
        // Offsets are whole grains.
        let apart = self.sides.map(|side| (side / grain).trunc());
        let turned = self.turned(up);
        let mut height = 0.0;
        for side in 0..3 {
            if weights[side] <= 0.0 {
                continue;
            }
            let number = 1.0 + 2.0 * side as f64 + f64::from(u8::from(turned[side] < 0.0));
            let at = |axis: usize, offset: f64| (self.origin[axis] + beneath[axis]) / grain + number * offset;
            height += weights[side]
                * self.map([at((side + 1) % 3, apart[0]), at((side + 2) % 3, apart[1])], finest);
        }
        height
    }

    fn octave(&self, q: [f64; 2], index: usize, level: i32) -> f64 {
        let width = 2_f64.powi(level);
        let shift = index as f64;
        perlin2([q[0] / width + shift * 7.31, q[1] / width + shift * 3.83], None, self.seed + index as u32)
    }

    /// The map of heights at `q` (grains).
    fn map(&self, q: [f64; 2], finest: f64) -> f64 {
        let top = self.octaves as i32;
        let presence = |level: i32| if level < 0 { 0.0 } else { (f64::from(level) - finest).clamp(0.0, 1.0) };
        let bend = self.bend * 2_f64.powi(top) * presence(top);
        let bent = [q[0] + bend * self.octave(q, 0, top), q[1] + bend * self.octave(q, 1, top)];
        // Only what is large is bent.
        let rise = |low: f64, high: f64, value: f64| {
            let t = ((value - low) / (high - low)).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        };
        match self.relief {
            Relief::Continents(ocean, sea_floor, chains, hills) => {
                let octave = |index, level| presence(level) * self.octave(bent, index, level);
                let chain = octave(2, top) + 0.45 * octave(3, top - 1);
                let land: f64 = (0..9).map(|i| 0.58_f64.powi(i) * octave(4 + i as usize, top - i)).sum();
                let (mut ridges, mut rough, mut strength) = (0.56, 1.0_f64, 1.0);
                for i in 0..24 {
                    let level = top - 7 - i;
                    if presence(level) <= 0.0 {
                        break;
                    }
                    let n = self.octave(q, 13 + i as usize, level);
                    let ridge = (1.0 - (n * n + 0.004).sqrt()).powi(2);
                    ridges += strength * presence(level) * rough * (ridge - 0.56);
                    rough = (1.8 * rough * ridge).min(1.0);
                    strength *= self.gain;
                }
                let rise_of_land = land - 0.373 * ocean;
                let share = hills + (1.0 - hills) * (-(chain / chains).powi(2)).exp();
                self.swell * rise_of_land - sea_floor * (1.0 - rise(-0.34, -0.05, rise_of_land))
                    + 1.5
                        * self.peak_height
                        * rise(-0.03, 0.22, rise_of_land)
                        * share
                        * (1.0 - self.gain)
                        * ridges
            }
            Relief::Craters(share, depth, coarsest) => {
                let octave = |index, level| presence(level) * self.octave(bent, index, level);
                let land: f64 = (0..5).map(|i| 0.5_f64.powi(i) * octave(2 + i as usize, top - i)).sum();
                let rough: f64 = (0..24)
                    .map(|i| {
                        let level = top - 5 - i;
                        presence(level) * self.gain.powi(i) * self.octave(q, 7 + i as usize, level)
                    })
                    .sum();
                let step = rise(-0.15, 0.35, land);
                self.swell * (0.5 * land + 1.2 * (step - 0.5))
                    + self.peak_height * (1.0 - self.gain) * (0.25 + 0.75 * step) * rough
                    + self.craters(q, finest, share, depth, coarsest)
            }
        }
    }

    /// All craters of all places within reach, whichever they are.
    fn craters(&self, q: [f64; 2], finest: f64, share: f64, fresh: f64, coarsest: u32) -> f64 {
        let grain = self.scale / f64::from(1_u32 << self.octaves);
        let mut sum = 0.0;
        for size in 0..7 {
            let level = self.octaves as i32 - coarsest as i32 - 2 * size;
            let presence = (f64::from(level) - 1.0 - finest).clamp(0.0, 1.0);
            if level < 0 || presence <= 0.0 {
                break;
            }
            let width = 2_f64.powi(level);
            let t = q.map(|x| x / width);
            let cell = t.map(|x| x.floor() as i64);
            for place in 0..25 {
                let place = [cell[0] + place % 5 - 2, cell[1] + place / 5 - 2];
                let key = pcg(self.seed + 977 + level as u32);
                let bits = pcg((place[0] as u32).wrapping_add(pcg((place[1] as u32).wrapping_add(key))));
                let where_in = pcg2d([bits, 5]).map(unit);
                let kind = pcg2d([bits, 6]).map(unit);
                if kind[0] >= share {
                    continue;
                }
                let radius = 0.09 + 0.28 * kind[1].powi(3);
                let middle: [f64; 2] =
                    std::array::from_fn(|axis| place[axis] as f64 + 0.25 + 0.5 * where_in[axis]);
                let reach = (t[0] - middle[0]).hypot(t[1] - middle[1]) / radius;
                let km = 2.0 * radius * width * grain / 1000.0;
                let deep = 1000.0 * (0.21 * km.powf(0.81)).min(0.36 * km.powf(0.49));
                sum += presence * fresh * deep * crater(reach);
            }
        }
        sum
    }

    /// Where a ray from `origin` in the unit `direction` first meets the ground within `far` (m): by steps of a third of
    /// the height above it and no less than `shortest` (m), then halvings.
    pub fn first_crossing(
        &self,
        origin: [f64; 3],
        direction: [f64; 3],
        far: f64,
        shortest: f64,
    ) -> Option<f64> {
        let above = |t: f64| {
            let p = std::array::from_fn(|axis| origin[axis] + t * direction[axis]);
            self.place(p).1 - self.height(p, 0.0)
        };
        let mut t = 0.0;
        while t < far {
            let height = above(t);
            if height <= 0.0 {
                return Some(t);
            }
            let next = t + (0.3 * height).max(shortest);
            if above(next) <= 0.0 {
                let (mut low, mut high) = (t, next);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    if above(middle) <= 0.0 {
                        high = middle;
                    } else {
                        low = middle;
                    }
                }
                return Some(high);
            }
            t = next;
        }
        None
    }
}

/// A crater of depth 1 at `reach` radii from its middle.
fn crater(reach: f64) -> f64 {
    let t = ((reach - 0.35) / 0.65).clamp(0.0, 1.0);
    let u = ((reach - 1.0) / if reach < 1.0 { 0.45 } else { 1.0 }).clamp(-1.0, 1.0);
    0.8 * (t * t * (3.0 - 2.0 * t) - 1.0) + 0.2 * (1.0 - u * u).powi(2)
}

/// Weights of the planes across x, y and z: |direction|^sharpness, normalised, what is below .004 to .04 faded out.
pub fn weights(direction: [f64; 3], sharpness: f64) -> [f64; 3] {
    let raised = direction.map(|x| x.abs().powf(sharpness));
    let sum: f64 = raised.iter().sum();
    let kept = raised.map(|x| {
        let share = x / sum;
        let t = ((share - 0.004) / 0.036).clamp(0.0, 1.0);
        share * t * t * (3.0 - 2.0 * t)
    });
    let total: f64 = kept.iter().sum();
    kept.map(|x| x / total)
}
