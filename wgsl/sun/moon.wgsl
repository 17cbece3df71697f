// The moon: where it stands, its phase, and how strongly it shines.

#include <light/disc.wgsl>
#include <math/rotation.wgsl>
#include <sun/sun.wgsl>

/// Whether there is a moon: in the sky, and by night as the light that throws the shadows.
#option moon.shines = false
/// Where the moon stands, clockwise from north. Its phase follows from where the sun is: full is opposite to it.
#param moon.azimuth: f32 = 150.0, range -360 .. 360, unit deg, live
/// How high the moon stands above the horizon.
#param moon.elevation: f32 = 35.0, range -90 .. 90, unit deg, live
/// Angular radius of the moon. The real one has 0.26.
#param moon.radius: f32 = 0.26, range 0.05 .. 10, unit deg
/// How much brighter than the real one the moon is.
#param moon.brightness: f32 = 1.0, range 0 .. 1000, log
/// Colour of moonlight beside sunlight: the moon's ground is a little red. Linear sRGB.
#param moon.color: vec3f = (1.10, 0.99, 0.83), range 0 .. 4

/// Unit vector to the moon.
fn moon_direction() -> vec3f {
    return direction_from_angles(moon.azimuth, moon.elevation);
}

/// Angle at the moon between the sun and the eye (rad): 0 at full moon, pi at new moon.
fn moon_phase_angle() -> f32 {
    // atan2 of the lengths of sum and difference keeps its digits at both ends.
    let to_sun = sun_direction();
    let to_moon = moon_direction();
    return 2.0 * atan2(length(to_sun + to_moon), max(length(to_sun - to_moon), 1e-9));
}

/// Irradiance of a surface that faces the full moon, linear sRGB, outside of the air: 14.01 magnitudes below the sun's
/// (Allen 1976), or a 402,000th.
fn moon_full_light() -> vec3f {
    return 2.489e-6 * moon.brightness * moon.color * sun_light();
}

/// Irradiance of a surface that faces the moon in its phase, linear sRGB, outside of the air.
fn moon_light() -> vec3f {
    return moon_phase_law(moon_phase_angle()) * moon_full_light();
}
