// How light it is out of doors, by day and by night.

/// Illuminance (lx) of level ground by a cloudless sky and the sun in it, for the sun at `elevation` (rad).
///
/// 129,000 with the sun overhead, 4,500 at 5°, 760 at 0° (refraction lifts it above the horizon), 3.4 at -6°, .008 at -12°
/// and 6.5e-4 at -18° and below, where the stars and the air's own glow take over. The polynomials of the US Naval
/// Observatory (Janiczek & DeYoung 1987, Circular 171), at sea level on Earth; goes up with the sun, but for
/// jumps of at most 1 % where one polynomial meets the next.
fn daylight_illuminance(elevation: f32) -> f32 {
    let x = clamp(elevation * 0.63661977, -0.2, 1.0); // 1: overhead
    var c = vec4f(3.74, 3.97, -4.07, 1.47);
    if x < -0.13333333 {
        c = vec4f(13.84, 262.72, 1447.42, 2797.93);
    } else if x < -0.05555556 {
        c = vec4f(2.70, 12.17, -431.69, -1899.83);
    } else if x < -0.00888889 {
        c = vec4f(2.88, 21.81, -258.11, -858.36);
    } else if x < 0.05555556 {
        c = vec4f(2.88, 22.26, -207.64, 1034.30);
    } else if x < 0.22222222 {
        c = vec4f(3.05, 13.28, -45.98, 64.33);
    }
    return exp2(3.3219281 * (c.x + x * (c.y + x * (c.z + x * c.w))));
}
