//! How the power of a map is spread over its frequencies.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

/// The logarithm of the mean power in each ring of frequencies 0 .. `rings` (cycles over the map), of a square map of
/// `size`² values, row by row, seen through a Hann window.
#[must_use]
pub fn log_power_of_rings(map: &[f64], size: usize, rings: usize) -> Vec<f64> {
    let hann: Vec<f64> =
        (0..size).map(|i| (std::f64::consts::PI * (i as f64 + 0.5) / size as f64).sin().powi(2)).collect();
    let mut plane: Vec<Complex<f32>> = Vec::with_capacity(size * size);
    for (row, y) in map.chunks(size).zip(&hann) {
        plane.extend(row.iter().zip(&hann).map(|(value, x)| Complex::new((value * x * y) as f32, 0.0)));
    }
    let transform = FftPlanner::new().plan_fft_forward(size);
    transform.process(&mut plane);
    let mut power = vec![(0.0, 0.0); rings + 1];
    // The map is real: columns -x are those of x, turned about.
    for x in 0..=rings {
        let mut column: Vec<_> = plane.iter().skip(x).step_by(size).copied().collect();
        transform.process(&mut column);
        for (y, amplitude) in column.iter().enumerate() {
            let ring = (x as f64).hypot(y.min(size - y) as f64).round() as usize;
            if let Some((sum, count)) = power.get_mut(ring) {
                *sum += f64::from(amplitude.norm_sqr());
                *count += 1.0;
            }
        }
    }
    power.into_iter().map(|(sum, count): (f64, f64)| (sum / count).ln()).collect()
}

/// Slope of the line through `points`, least squares.
#[must_use]
pub fn slope_of_line(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let middle = points.iter().map(|point| point.0).sum::<f64>() / count;
    let rise: f64 = points.iter().map(|point| (point.0 - middle) * point.1).sum();
    rise / points.iter().map(|point| (point.0 - middle).powi(2)).sum::<f64>()
}
