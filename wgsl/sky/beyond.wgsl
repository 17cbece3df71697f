// What shines behind the air.

#include <sun/sun.wgsl>

/// Radiance from beyond the air in the unit `direction`: the sun's disc.
fn sky_beyond(direction: vec3f) -> vec3f {
    return sun_disc(direction);
}

/// Radiance of the sun's disc; 0 outside of it.
///
/// At most 200: a real disc is brighter, but more would only make edges that no number of samples smooths.
fn sun_disc(direction: vec3f) -> vec3f {
    let edge = cos(sun.radius);
    let toward = dot(direction, sun_direction());
    let inside = smoothstep(edge - 0.2 * (1.0 - edge), edge + 0.2 * (1.0 - edge), toward);
    let solid_angle = 6.2831853 * (1.0 - edge);
    return inside * min(sun_light() / solid_angle, vec3f(200.0));
}
