// The light that throws the shadows: the sun, or the moon by night.

#include <sun/moon.wgsl>
#include <sun/sun.wgsl>

#if moon.shines
const KEY_CHANGE: f32 = -0.08726646; // -5°: twilight has no shadows
const KEY_FADE: f32 = 0.01745329; // 1°
#endif

/// Whether it is the moon.
fn key_is_moon() -> bool {
#if moon.shines
    return sun.elevation < KEY_CHANGE;
#else
    return false;
#endif
}

/// Unit vector to the light that throws the shadows: the sun's, and if the moon shines, the moon's once the sun is 5°
/// below the horizon. At the change both give no light.
fn key_direction() -> vec3f {
#if moon.shines
    return select(sun_direction(), moon_direction(), key_is_moon());
#else
    return sun_direction();
#endif
}

/// Its irradiance on a surface that faces it, linear sRGB, before any air. If the moon shines, the sun's goes out between
/// -4° and -5°, where the planet hides it anyway, and the moon's comes up to -6°.
fn key_light() -> vec3f {
#if moon.shines
    let fade = smoothstep(0.0, KEY_FADE, abs(sun.elevation - KEY_CHANGE));
    return fade * select(sun_light(), moon_light(), key_is_moon());
#else
    return sun_light();
#endif
}

/// Its angular radius (rad).
fn key_radius() -> f32 {
#if moon.shines
    return select(sun.radius, moon.radius, key_is_moon());
#else
    return sun.radius;
#endif
}
