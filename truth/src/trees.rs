//! Distances to ellipsoids of revolution, the form of broadleaved crowns.

/// Distance from `(across, up)` to the ellipse with these half-axes, for points outside of it: the exact one, by
/// bisection for the foot of the perpendicular (Eberly, "Distance from a point to an ellipse", 2013).
#[must_use]
pub fn ellipse_distance(point: [f64; 2], radii: [f64; 2]) -> f64 {
    let [x, y] = point.map(f64::abs);
    let [a, b] = radii;
    // The foot is (a² x / (t + a²), b² y / (t + b²)) for the t ≥ 0 that puts it on the ellipse.
    let excess = |t: f64| (a * x / (t + a * a)).powi(2) + (b * y / (t + b * b)).powi(2) - 1.0;
    let (mut low, mut high) = (0.0, a.max(b) * (x.hypot(y) + a.max(b)));
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if excess(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let t = 0.5 * (low + high);
    (x - a * a * x / (t + a * a)).hypot(y - b * b * y / (t + b * b))
}

/// The usual bound of that distance, k₀ (k₀ − 1) / k₁ with k₀ = |p / r| and k₁ = |p / r²|.
#[must_use]
pub fn ellipse_bound(point: [f64; 2], radii: [f64; 2]) -> f64 {
    let scaled = [point[0] / radii[0], point[1] / radii[1]];
    let steep = [scaled[0] / radii[0], scaled[1] / radii[1]];
    let k0 = scaled[0].hypot(scaled[1]);
    k0 * (k0 - 1.0) / steep[0].hypot(steep[1])
}

/// Length of the gradient of [`ellipse_bound`], by central differences.
#[must_use]
pub fn ellipse_bound_slope(point: [f64; 2], radii: [f64; 2]) -> f64 {
    let h = 1e-5;
    let along = |dx: f64, dy: f64| {
        let ahead = ellipse_bound([point[0] + dx, point[1] + dy], radii);
        let behind = ellipse_bound([point[0] - dx, point[1] - dy], radii);
        (ahead - behind) / (2.0 * h)
    };
    along(h, 0.0).hypot(along(0.0, h))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_to_a_circle_is_known() {
        assert!((ellipse_distance([3.0, 4.0], [2.0, 2.0]) - 3.0).abs() < 1e-12);
        assert!((ellipse_distance([0.0, 9.0], [2.0, 5.0]) - 4.0).abs() < 1e-9);
    }
}
