// The sun: where it stands and how strongly it shines.

#include <math/rotation.wgsl>

/// Where the sun stands, clockwise from north.
#param sun.azimuth: f32 = 215.0, range -360 .. 360, unit deg, live
/// How high the sun stands above the horizon.
#param sun.elevation: f32 = 18.0, range -90 .. 90, unit deg, live
/// Colour of sunlight on the ground: warm when the sun is low. Linear sRGB.
#param sun.color: vec3f = (1.0, 0.84, 0.64), color
/// Irradiance of a surface that faces the sun, in the units of radiance times pi: at pi, a white wall in full sun
/// is 1.
#param sun.irradiance: f32 = 4.0, range 0 .. 100
/// Angular radius of the sun: how soft the edges of its shadows are. The real one has 0.267.
#param sun.radius: f32 = 0.267, range 0.05 .. 10, unit deg

/// Unit vector to the sun.
fn sun_direction() -> vec3f {
    return direction_from_angles(sun.azimuth, sun.elevation);
}

/// Irradiance of a surface that faces the sun, linear sRGB.
fn sun_light() -> vec3f {
    return sun.irradiance * sun.color;
}
