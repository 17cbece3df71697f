//! Phase functions in f64, from their definitions, and sums over the sphere.

use std::f64::consts::PI;

/// Henyey & Greenstein's.
#[must_use]
pub fn henyey_greenstein(cosine: f64, g: f64) -> f64 {
    (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * cosine).powf(1.5))
}

/// Draine's; Cornette & Shanks's for `alpha` = 1.
#[must_use]
pub fn draine(cosine: f64, g: f64, alpha: f64) -> f64 {
    let whole = 1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0;
    henyey_greenstein(cosine, g) * (1.0 + alpha * cosine * cosine) / whole
}

/// Mean cosine of Draine's.
#[must_use]
pub fn draine_mean(g: f64, alpha: f64) -> f64 {
    g * (1.0 + alpha * (3.0 + 2.0 * g * g) / 5.0) / (1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0)
}

/// Schlick's, of his k.
#[must_use]
pub fn schlick(cosine: f64, k: f64) -> f64 {
    (1.0 - k * k) / (4.0 * PI * (1.0 - k * cosine).powi(2))
}

/// Mean cosine of Schlick's.
#[must_use]
pub fn schlick_mean(k: f64) -> f64 {
    if k == 0.0 {
        return 0.0;
    }
    1.0 / k - (1.0 - k * k) / (2.0 * k * k) * ((1.0 + k) / (1.0 - k)).ln()
}

/// Jendersie & d'Eon's fit for droplets of `diameter` um: g of the first lobe; g, alpha and share of the Draine lobe.
#[must_use]
pub fn droplets(diameter: f64) -> [f64; 4] {
    [
        (-0.099_056_7 / (diameter - 1.671_54)).exp(),
        (-2.206_79 / (diameter + 3.910_29) - 0.428_934).exp(),
        (3.624_89 - 8.292_88 / (diameter + 5.528_25)).exp(),
        (-0.599_085 / (diameter - 0.641_583) - 0.665_888).exp(),
    ]
}

/// The fit's phase function.
#[must_use]
pub fn hg_draine(cosine: f64, diameter: f64) -> f64 {
    let [narrow, wide, alpha, share] = droplets(diameter);
    (1.0 - share) * henyey_greenstein(cosine, narrow) + share * draine(cosine, wide, alpha)
}

/// Its mean cosine.
#[must_use]
pub fn hg_draine_mean(diameter: f64) -> f64 {
    let [narrow, wide, alpha, share] = droplets(diameter);
    (1.0 - share) * narrow + share * draine_mean(wide, alpha)
}

/// Cosines from -1 to 1, all different `f32`, an odd number of them, crowded toward both ends: where narrow peaks are
/// still smooth from one to the next.
#[must_use]
pub fn crowded_cosines() -> Vec<f32> {
    let side = 6000;
    // From the pole outward: 1 - cosine grows from one unit in the last place by .3 % a step, then evenly.
    let mut off: Vec<f64> =
        (0..=side).map(|i| 6e-8 * (1.7e7_f64).powf(f64::from(i) / f64::from(side))).collect();
    off.insert(0, 0.0);
    let mut all: Vec<f32> = off.iter().map(|&off| (1.0 - off.min(1.0)) as f32).collect();
    all.extend(off.iter().map(|&off| (off.min(1.0) - 1.0) as f32));
    all.push(0.0);
    all.sort_by(f32::total_cmp);
    all.dedup();
    if all.len().is_multiple_of(2) {
        let middle = all.len() / 2;
        all.remove(middle);
    }
    all
}

/// Integral of a function of the cosine over the sphere (times 1 and times the cosine), known at [`crowded_cosines`]:
/// Simpson's rule for uneven steps.
#[must_use]
pub fn over_the_sphere(cosines: &[f32], value: &[f64]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for i in (0..cosines.len() - 2).step_by(2) {
        let [a, b, c] = [0, 1, 2].map(|j| f64::from(cosines[i + j]));
        let (h, k) = (b - a, c - b);
        let weights =
            [(h + k) / 6.0 * (2.0 - k / h), (h + k).powi(3) / (6.0 * h * k), (h + k) / 6.0 * (2.0 - h / k)];
        for (j, weight) in weights.iter().enumerate() {
            let part = 2.0 * PI * weight * value[i + j];
            sums[0] += part;
            sums[1] += part * f64::from(cosines[i + j]);
        }
    }
    sums
}
