//! Reflection in f64: Fresnel's equations by angles, and means over rough surfaces by summing.

/// Reflectance of unpolarised light at `angle` (rad) of incidence: Fresnel's sine and tangent laws.
#[must_use]
pub fn fresnel(angle: f64, ior: f64) -> f64 {
    if angle.sin() / ior >= 1.0 {
        return 1.0;
    }
    let refracted = (angle.sin() / ior).asin();
    if angle < 1e-7 {
        return ((ior - 1.0) / (ior + 1.0)).powi(2);
    }
    let perpendicular = ((angle - refracted).sin() / (angle + refracted).sin()).powi(2);
    let parallel = ((angle - refracted).tan() / (angle + refracted).tan()).powi(2);
    f64::midpoint(perpendicular, parallel)
}

/// What an eye sees of facets whose slopes are spread normally.
#[derive(Debug, Clone, Copy)]
pub struct Facets {
    /// Their area as seen, over the cosine of the elevation.
    pub area: f64,
    /// Mean slope toward the eye, each facet counted by its area as seen.
    pub mean: f64,
    /// And its standard deviation.
    pub deviation: f64,
    /// Mean reflectance of water, counted in the same way; slopes across included.
    pub reflectance: f64,
}

/// Sums over slopes from -8 to 8 deviations, along the view and across it.
#[must_use]
pub fn facets(tan_view: f64, deviation: f64) -> Facets {
    let (cosine, sine) = (1.0 / tan_view.hypot(1.0), tan_view / tan_view.hypot(1.0));
    let (mut area, mut first, mut second, mut light, mut planes) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let steps = 400;
    for i in 0..=steps {
        let along = 16.0 * f64::from(i) / f64::from(steps) - 8.0;
        let slope = deviation * along;
        let seen = (slope + tan_view).max(0.0) * (-0.5 * along * along).exp();
        planes += (-0.5 * along * along).exp();
        area += seen;
        first += seen * slope;
        second += seen * slope * slope;
        if seen > 0.0 {
            let (mut sum, mut weights) = (0.0, 0.0);
            for j in -16..=16 {
                let across = f64::from(j) / 4.0;
                let weight = (-0.5 * across * across).exp();
                let size = (1.0 + slope * slope + (deviation * across).powi(2)).sqrt();
                let cos_theta = ((slope * cosine + sine) / size).min(1.0);
                sum += weight * fresnel(cos_theta.acos(), 1.333);
                weights += weight;
            }
            light += seen * sum / weights;
        }
    }
    let mean = first / area;
    Facets {
        area: area / planes,
        mean,
        deviation: (second / area - mean * mean).max(0.0).sqrt(),
        reflectance: light / area,
    }
}
