// The sphere of the stars, and how it stands above the horizon.

#include <math/rotation.wgsl>

/// Latitude of the place: how high the pole of the stars stands in the north.
#param stars.latitude: f32 = 46.0, range -90 .. 90, unit deg
/// How far the stars have turned about their pole: local sidereal time, 15° an hour.
#param stars.turn: f32 = 280.0, range -3600 .. 3600, unit deg, live

/// The unit `direction` among the stars: y toward their north pole, x toward right ascension 0, -z toward 90°.
fn celestial_direction(direction: vec3f) -> vec3f {
    let along = vec3f(0.0, sin(stars.latitude), -cos(stars.latitude)); // to the pole
    let meridian = vec3f(0.0, cos(stars.latitude), sin(stars.latitude)); // to where the equator is highest
    let turned = rotate2(vec2f(dot(direction, meridian), direction.x), stars.turn);
    return vec3f(turned.x, dot(direction, along), -turned.y);
}
