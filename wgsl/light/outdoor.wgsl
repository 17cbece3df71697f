// Light on matt ground under an open sky.

/// Radiance of a matt surface lit by the sun, the sky and the ground around it (after Quilez, "Outdoors lighting").
///
/// `normal`, `to_sun`: unit vectors. `from_sun`: irradiance of a surface that faces the sun, `from_sky`: of level
/// ground under an open sky. `shadow`: part of the sun that is seen, `openness`: part of the sky. The bounce comes
/// from sunlit ground of `ground_albedo`, mostly from the side opposite to the sun, since that ground faces it.
fn outdoor_radiance(
    albedo: vec3f,
    normal: vec3f,
    to_sun: vec3f,
    from_sun: vec3f,
    from_sky: vec3f,
    shadow: f32,
    openness: f32,
    ground_albedo: vec3f,
) -> vec3f {
    let direct = from_sun * max(dot(normal, to_sun), 0.0) * shadow;
    let above = from_sky * (0.5 + 0.5 * normal.y) * openness;
    let level = max(length(to_sun.xz), 1e-4);
    let away = vec3f(-to_sun.x / level, 0.0, -to_sun.z / level);
    let seen_ground = (0.5 - 0.5 * normal.y) + 0.35 * max(dot(normal, away), 0.0);
    let lit_ground = ground_albedo * (from_sun * max(to_sun.y, 0.0) + from_sky * 0.5);
    let bounce = lit_ground * seen_ground * (0.4 + 0.6 * openness);
    return albedo * (direct + above + bounce) / 3.14159265;
}
