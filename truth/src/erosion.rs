//! The gully filter of `fractal/erosion.wgsl`, from its definition: the change of height only, no derivatives carried.

use crate::hash::{pcg, pcg2d, unit};
use std::f64::consts::TAU;

/// How land is eroded; the fields are those of the shader's `Erosion`.
#[derive(Debug, Clone, Copy)]
#[expect(missing_docs, reason = "documented in the shader")]
pub struct Erosion {
    pub width: f64,
    pub strength: f64,
    pub octaves: f64,
    pub gain: f64,
    pub lacunarity: f64,
    pub assumed_slope: f64,
    pub level_slope: f64,
    pub crest_roundness: f64,
    pub gully_roundness: f64,
    pub bottom: f64,
    pub top: f64,
}

/// Change of height at `p` of land that is so high and so steep there.
#[must_use]
pub fn erosion2(p: [f64; 2], height: f64, gradient: [f64; 2], how: &Erosion, seed: u32) -> f64 {
    let squared = |v: [f64; 2]| v[0] * v[0] + v[1] * v[1];
    let shortened = |v: [f64; 2], level2: f64| v.map(|part| part / (squared(v) + level2).sqrt());

    let fall = shortened(gradient, how.level_slope.powi(2));
    let mut slope = fall.map(|part| how.assumed_slope * part);
    let h = ((height - how.bottom) / (how.top - how.bottom)).clamp(0.0, 1.0);
    let mut form = 2.0 * (3.0 * h * h - 2.0 * h * h * h) - 1.0;
    let mut hold = squared(fall) * (1.0 - form.powi(4));
    let mut change = 0.0;
    let mut left = 1.0;
    for i in 0..8 {
        let presence = (how.octaves - f64::from(i)).clamp(0.0, 1.0);
        if presence == 0.0 {
            break;
        }
        let cell = how.width / how.lacunarity.powi(i);
        let share = (1.0 - how.gain) * how.gain.powi(i);
        let down = shortened(slope, 0.1 * how.assumed_slope.powi(2));
        let led = hold * squared(down);
        let wave = [-TAU * down[1], TAU * down[0]];
        let (even, odd) = stripes(p.map(|part| part / cell), wave, seed + i as u32);
        form += presence * led * (profile(even, how.crest_roundness, how.gully_roundness) - form);
        change += share * form;
        left -= share;
        // cos(k·q) falls by k sin(k·q): that is the slope.
        let height = how.strength * share * presence / cell;
        slope = [0, 1].map(|axis| slope[axis] - height * led * odd * wave[axis]);
        hold *= 1.0 - even.powi(4);
    }
    how.strength * (change + left * form)
}

/// Cosine and sine stripes around `q`, their amplitude near 1 but where neighbours cancel.
fn stripes(q: [f64; 2], wave: [f64; 2], seed: u32) -> (f64, f64) {
    let key = pcg(seed);
    let (mut even, mut odd, mut all) = (0.0, 0.0, 0.0);
    let corner = q.map(|part| part.floor() as i32);
    for y in corner[1] - 2..corner[1] + 4 {
        for x in corner[0] - 2..corner[0] + 4 {
            let bits = pcg2d([(x as u32).wrapping_add(key), (y as u32).wrapping_add(key)]);
            let middle =
                [f64::from(x) + 0.8 * (unit(bits[0]) - 0.5), f64::from(y) + 0.8 * (unit(bits[1]) - 0.5)];
            let offset = [q[0] - middle[0], q[1] - middle[1]];
            let distance2 = offset[0] * offset[0] + offset[1] * offset[1];
            let weight = (1.0 - distance2 / 1.6_f64.powi(2)).max(0.0).powi(4);
            if weight == 0.0 {
                continue;
            }
            let phase = wave[0] * offset[0] + wave[1] * offset[1];
            even += weight * phase.cos();
            odd += weight * phase.sin();
            all += weight;
        }
    }
    let floor = 0.35_f64;
    let size = (even * even + odd * odd + (floor * all).powi(2)).sqrt() / (1.0 + floor * floor).sqrt();
    (even / size, odd / size)
}

/// A cosine with its crests and bottoms sharpened.
fn profile(x: f64, crest: f64, gully: f64) -> f64 {
    let root = |part: f64, r: f64| ((part + r * r).sqrt() - r) / ((1.0 + r * r).sqrt() - r);
    root((1.0 + x) / 2.0, gully.max(0.01)) - root((1.0 - x) / 2.0, crest.max(0.01))
}
