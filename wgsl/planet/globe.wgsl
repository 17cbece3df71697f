// Where on its planet a scene lies, and the planet turned accordingly: the camera stays near the origin, where numbers
// are small.

#include <geometry/globe.wgsl>
#include <math/precise.wgsl>
#include <sky/medium.wgsl>

/// Latitude of the world's origin, the point beneath the camera's x and z of 0.
#param planet.latitude: f32 = 20.0, range -90 .. 90, unit deg
/// Longitude of the world's origin.
#param planet.longitude: f32 = 0.0, range -360 .. 360, unit deg

/// The planet's own axes, seen from the world: the columns are the world's east, up and south, in coordinates whose y is
/// the planet's axis of rotation.
fn planet_axes() -> mat3x3f {
    let c = cos(planet.latitude);
    let s = sin(planet.latitude);
    // Of the meridian. Two numbers, no vector: made of overrides, naga would take it apart only once.
    let x = cos(planet.longitude);
    let z = -sin(planet.longitude);
    return mat3x3f(vec3f(z, 0.0, -x), vec3f(c * x, s, c * z), vec3f(s * x, -c, s * z));
}

/// Height (m) of `p` (m) above sea level.
fn planet_altitude(p: vec3f) -> f32 {
    return globe_height(p, sky.ground_radius);
}

/// Unit vector upward at `p` (m).
fn planet_up(p: vec3f) -> vec3f {
    return globe_up(p, sky.ground_radius);
}

/// The point of the planet's sphere beneath `p` (m), in the planet's own axes and in units of `unit` (m).
///
/// Near the world's origin it is as exact as `p`: the origin's own place enters as whole cells.
fn planet_place(p: vec3f, unit: f32) -> Precise {
    let axes = planet_axes();
    let beneath = p - planet_altitude(p) * planet_up(p);
    return precise_moved(precise_place(axes[1] * (sky.ground_radius / unit)), (axes * beneath) / unit);
}
