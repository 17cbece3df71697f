//! Sums of octaves, from their definitions: Musgrave's multifractals (Ebert et al., "Texturing and Modeling") and kin.
//!
//! Values only. Gradients are differences of these, so that no rule of differentiation is taken twice.

use crate::noise::gradient;

/// A noise of the plane, by position and seed.
pub type Noise2 = fn([f64; 2], u32) -> f64;
/// A noise of space, by position and seed.
pub type Noise3 = fn([f64; 3], u32) -> f64;

/// The octaves of a fractal.
#[derive(Debug, Clone, Copy)]
pub struct Octaves {
    /// How many; the last one in part.
    pub count: f64,
    /// The strength of an octave over that of the one before.
    pub gain: f64,
    /// The frequency of an octave over that of the one before.
    pub lacunarity: f64,
}

/// One octave: its noise's number, how strong it is and how much of it there is.
struct Octave {
    number: u32,
    strength: f64,
    presence: f64,
}

impl Octaves {
    fn each(self) -> impl Iterator<Item = Octave> {
        let whole = self.count.ceil().max(0.0) as u32;
        (0..whole.min(16)).map(move |number| Octave {
            number,
            strength: self.gain.powi(number as i32),
            presence: (self.count - f64::from(number)).min(1.0),
        })
    }

    /// 1 + gain + gain² + …, the last term in part.
    #[must_use]
    pub fn sum(self) -> f64 {
        self.each().map(|octave| octave.strength * octave.presence).sum()
    }

    /// `p` in the plane of octave `number`, each octave turned by `angle` and shifted.
    fn place(self, p: [f64; 2], number: u32, angle: f64, shift: [f64; 2]) -> [f64; 2] {
        (0..number).fold(p, |[x, y], _| {
            let (s, c) = angle.sin_cos();
            [self.lacunarity * (c * x - s * y) + shift[0], self.lacunarity * (s * x + c * y) + shift[1]]
        })
    }
}

/// The angle of the 3-4-5 triangle.
fn usual_angle() -> f64 {
    0.6_f64.atan2(0.8)
}

const SHIFT: [f64; 2] = [37.31, 17.83];
const RIDGE_SHIFT: [f64; 2] = [-21.67, 43.19];
const MEAN_RIDGE: f64 = 0.606;
const MEAN_BILLOW: f64 = 0.245;

/// Σ gainⁱ · noise(qᵢ).
#[must_use]
pub fn fbm2(noise: Noise2, p: [f64; 2], seed: u32, octaves: Octaves) -> f64 {
    fbm2_turned(noise, p, seed, octaves, usual_angle(), SHIFT)
}

/// As [`fbm2`], with the turn and the shift of an octave given.
#[must_use]
pub fn fbm2_turned(
    noise: Noise2,
    p: [f64; 2],
    seed: u32,
    octaves: Octaves,
    angle: f64,
    shift: [f64; 2],
) -> f64 {
    octaves
        .each()
        .map(|o| o.strength * o.presence * noise(octaves.place(p, o.number, angle, shift), seed + o.number))
        .sum()
}

/// Σ gainⁱ · noise(qᵢ) in space.
#[must_use]
pub fn fbm3(noise: Noise3, p: [f64; 3], seed: u32, octaves: Octaves) -> f64 {
    let place = |number| {
        (0..number).fold(p, |[x, y, z], _| {
            let turned =
                [-2.0 * x - 3.0 * y - 6.0 * z, -3.0 * x + 6.0 * y - 2.0 * z, 6.0 * x + 2.0 * y - 3.0 * z];
            let shift = [37.31, 17.83, 53.47];
            std::array::from_fn(|axis| octaves.lacunarity * turned[axis] / 7.0 + shift[axis])
        })
    };
    octaves.each().map(|o| o.strength * o.presence * noise(place(o.number), seed + o.number)).sum()
}

/// Octaves of |noise|, rounded, the later ones about their mean.
#[must_use]
pub fn billow2(noise: Noise2, p: [f64; 2], seed: u32, octaves: Octaves, roundness: f64) -> f64 {
    let fold = |n: f64| (n.hypot(roundness) - roundness) / (1.0_f64.hypot(roundness) - roundness);
    octaves
        .each()
        .map(|o| {
            let n = noise(octaves.place(p, o.number, usual_angle(), SHIFT), seed + o.number);
            let mean = if o.number == 0 { 0.0 } else { MEAN_BILLOW };
            o.strength * o.presence * (fold(n) - mean)
        })
        .sum()
}

/// Octaves of (1 − |noise|)², rounded, the later ones about their mean and weighted by the one before.
#[must_use]
pub fn ridged2(
    noise: Noise2,
    p: [f64; 2],
    seed: u32,
    octaves: Octaves,
    sharpness: f64,
    roundness: f64,
) -> f64 {
    let mut sum = 0.0;
    let mut weight = 1.0;
    for o in octaves.each() {
        let n = noise(octaves.place(p, o.number, usual_angle(), RIDGE_SHIFT), seed + o.number);
        let signal = (1.0 - n.hypot(roundness)).powi(2);
        let mean = if o.number == 0 { 0.0 } else { MEAN_RIDGE };
        sum += o.strength * o.presence * weight * (signal - mean);
        // A parabola through 0 with its top, 1, where sharpness · signal = 2.
        let reached = (sharpness * signal).min(2.0);
        weight = reached * (1.0 - reached / 4.0);
    }
    sum
}

/// Octaves of noise + offset, each weighted by the product of those before, at most 1.
#[must_use]
pub fn hybrid2(noise: Noise2, p: [f64; 2], seed: u32, octaves: Octaves, offset: f64) -> f64 {
    let mut sum = 0.0;
    let mut weight = 1.0;
    for o in octaves.each() {
        let n = noise(octaves.place(p, o.number, usual_angle(), SHIFT), seed + o.number);
        let term = weight * o.strength * (n + offset);
        sum += o.presence * term;
        weight = match term {
            ..0.0 => term,
            0.0..2.0 => term * (1.0 - term / 4.0),
            _ => 1.0,
        };
    }
    sum
}

/// relief(p / size + strength · (drift of seed + 71, drift of seed + 72)).
#[must_use]
pub fn warp2(
    relief: &dyn Fn([f64; 2], u32) -> f64,
    drift: &dyn Fn([f64; 2], u32) -> f64,
    p: [f64; 2],
    seed: u32,
    size: f64,
    strength: f64,
) -> f64 {
    let at = p.map(|coordinate| coordinate / size);
    let bent = [at[0] + strength * drift(at, seed + 71), at[1] + strength * drift(at, seed + 72)];
    relief(bent, seed)
}

/// Octaves over 1 + damping · |gradient of the undamped sum so far|².
#[must_use]
pub fn damped2(noise: Noise2, p: [f64; 2], seed: u32, octaves: Octaves, damping: f64) -> f64 {
    let mut sum = 0.0;
    let mut slope = [0.0; 2];
    for o in octaves.each() {
        let octave = |p| {
            o.strength * o.presence * noise(octaves.place(p, o.number, usual_angle(), SHIFT), seed + o.number)
        };
        let rise = gradient(octave, p, 1e-5 * octaves.lacunarity.powi(-(o.number as i32)));
        slope = [slope[0] + rise[0], slope[1] + rise[1]];
        sum += octave(p) / (1.0 + damping * (slope[0] * slope[0] + slope[1] * slope[1]));
    }
    sum
}
