//! Light along a line through a medium, by sums so fine that their error is below 1e-6.

/// What is seen along a line lit from its far end.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    /// Part of the light from behind that comes through.
    pub transmittance: f64,
    /// Light gathered, each unit of optical depth giving off what comes through to it from `end`.
    pub radiance: f64,
    /// Mean distance of what is seen (m), `far` if nothing is.
    pub distance: f64,
}

/// The line from `near` to `far` (m), through `density` (1/m) that reaches up to `end` (m), from where it is lit.
pub fn seen(density: impl Fn(f64) -> f64, near: f64, far: f64, end: f64) -> Seen {
    const CELLS: usize = 100_000;
    let cell = (end - near) / CELLS as f64;
    let depths: Vec<f64> =
        (0..CELLS).map(|index| density(near + (index as f64 + 0.5) * cell) * cell).collect();
    let mut ahead: f64 = depths.iter().sum();
    let (mut behind, mut radiance, mut moment) = (0.0_f64, 0.0, 0.0);
    for (index, depth) in depths.iter().enumerate() {
        let place = near + (index as f64 + 0.5) * cell;
        if place > far {
            break;
        }
        ahead -= depth;
        let weight = (-behind).exp() * (1.0 - (-depth).exp());
        radiance += weight * (-(ahead + 0.5 * depth)).exp();
        moment += weight * place;
        behind += depth;
    }
    let transmittance = (-behind).exp();
    let covered = 1.0 - transmittance;
    let distance = if covered > 0.0 { moment / covered } else { far };
    Seen { transmittance, radiance, distance }
}

/// What comes through `density` (1/m) from `near` to `far` (m).
pub fn through(density: impl Fn(f64) -> f64, near: f64, far: f64) -> f64 {
    const CELLS: usize = 100_000;
    let cell = (far - near) / CELLS as f64;
    let depth: f64 = (0..CELLS).map(|index| density(near + (index as f64 + 0.5) * cell) * cell).sum();
    (-depth).exp()
}
