// The light that falls on things out of doors.

/// The light at a place. By night the moon stands in for the sun.
struct Daylight {
    /// Unit vector to the sun.
    to_sun: vec3f,
    /// Angular radius of the sun (rad).
    radius: f32,
    /// Irradiance of a surface that faces the sun, what the air took of it taken off; nothing else in the way.
    sun: vec3f,
    /// Irradiance of level ground by the whole sky, without the sun's disc.
    sky: vec3f,
}
