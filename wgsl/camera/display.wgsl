// From the light that reaches the camera to the numbers that a display takes.

#include <color/blackbody.wgsl>
#include <color/dither.wgsl>
#include <color/srgb.wgsl>
#include <color/tone_map.wgsl>
#include <frame.wgsl>
#include <light/disc.wgsl>
#include <light/illuminance.wgsl>
#include <sun/moon.wgsl>
#include <sun/sun.wgsl>

/// Exposure: each step doubles the light.
#param display.exposure: f32 = 1.0, range -24 .. 40, unit EV
/// Whether the exposure goes with the light out of doors: longer by dusk, and longest by night. `display.exposure` is then
/// that by day.
#option display.auto_exposure = false
/// How much of a loss of light the automatic exposure makes up for: 1 shows the night as bright as the day.
#param display.adaptation: f32 = 0.9, range 0 .. 1
/// Colour temperature of the light that is shown as white: below 6,600 daylight turns bluer.
#param display.temperature: f32 = 6600.0, range 2000 .. 20000, log, unit K
/// How light beyond the display's white is brought back. `none` only encodes: decoded again it is linear light.
#option display.tone_map = exponential { exponential, reinhard, aces, agx, neutral, none }
/// What light, once exposed, becomes the display's white where `display.tone_map` is `reinhard`.
#param display.white: f32 = 8.0, range 1 .. 1000, log
/// Whether noise hides the steps of 8-bit displays. Linear light (`display.tone_map` is `none`) has none on it.
#option display.dither = true

/// Exposure (EV), of which each step doubles the light.
///
/// The automatic one is `display.exposure` where the sun is 45° high; from there it goes up with the logarithm of the
/// illuminance that a clear day, its twilight and its night have at that height of the sun: by 2.5 EV at 10°, 8.9 at -3°,
/// 17 at -9° and 24 from -18° on (at an adaptation of .9).
/// Where the moon shines it counts as the sun does: with a full moon at 45° the night's is 17 EV. Takes no account of
/// clouds.
fn display_stops() -> f32 {
#if display.auto_exposure
    var illuminance = daylight_illuminance(sun.elevation);
#if moon.shines
    let share = 2.489e-6 * moon.brightness * moon_phase_law(moon_phase_angle()); // of the sun's
    illuminance += share * daylight_illuminance(moon.elevation);
#endif
    return display.exposure + display.adaptation * log2(77850.0 / illuminance);
#else
    return display.exposure;
#endif
}

/// sRGB-encoded colour of linear `radiance` at the pixel `frag_coord`. 0 .. 1 but for the dither's .002; with
/// `display.tone_map = none` unbounded above.
fn display_color(radiance: vec3f, frag_coord: vec2f) -> vec3f {
    let balance = blackbody_color(6600.0) / max(blackbody_color(display.temperature), vec3f(0.02));
    let exposed = max(radiance, vec3f(0.0)) * balance * exp2(display_stops());
#if display.tone_map == exponential
    let shown = tone_map_exponential(exposed);
#elif display.tone_map == reinhard
    let shown = tone_map_reinhard_white(exposed, display.white);
#elif display.tone_map == aces
    let shown = tone_map_aces(exposed);
#elif display.tone_map == agx
    let shown = tone_map_agx(exposed);
#elif display.tone_map == neutral
    let shown = tone_map_neutral(exposed);
#else
    let shown = exposed;
#endif
#if display.dither && display.tone_map != none
    return dither_255(srgb_encode(shown), frag_coord, frame.index);
#else
    return srgb_encode(shown);
#endif
}
