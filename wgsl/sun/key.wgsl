// The light that throws the shadows.

#include <sun/sun.wgsl>

/// Unit vector to the light that throws the shadows.
fn key_direction() -> vec3f {
    return sun_direction();
}

/// Its irradiance on a surface that faces it, linear sRGB, before any air.
fn key_light() -> vec3f {
    return sun_light();
}

/// Its angular radius (rad).
fn key_radius() -> f32 {
    return sun.radius;
}
