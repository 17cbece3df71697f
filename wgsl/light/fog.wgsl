// Light lost and gained on the way through air that thins out with height.

/// How much air a ray passes, as the length of sea-level air that holds as much (m).
///
/// `origin_y`: height of the start above sea level (m), `direction_y` of the unit direction, `distance` (m), and
/// `scale_height` (m): over which the air thins by e. Exact for a flat world; never negative, finite for finite input.
fn air_mass(origin_y: f32, direction_y: f32, distance: f32, scale_height: f32) -> f32 {
    let start = exp(clamp(-origin_y / scale_height, -20.0, 20.0));
    let climb = clamp(direction_y * distance / scale_height, -20.0, 80.0); // in scale heights
    if abs(climb) < 1e-3 {
        return start * distance * (1.0 - 0.5 * climb); // the series: the quotient below loses its digits
    }
    return start * distance * (1.0 - exp(-climb)) / climb;
}
