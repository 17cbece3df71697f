// Waves of water particles on circles (Gerstner 1802): crests sharper than troughs.

#include <frame.wgsl>
#include <math/rotation.wgsl>
#include <noise/pcg.wgsl>
#include <quality.wgsl>
#include <water/wind.wgsl>

/// How far the crests are sharpened: 0 sines, 1 the sharpest that nowhere fold over.
#param water.chop: f32 = 0.8, range 0 .. 1
/// How deep the water is, as far as the waves feel it: in shallow water long waves are slow.
#param water.swell_depth: f32 = 200.0, range 0.1 .. 10000, log, unit m

#if quality == low
const GERSTNER_WAVES: i32 = 8;
#elif quality == medium
const GERSTNER_WAVES: i32 = 14;
#else
const GERSTNER_WAVES: i32 = 24;
#endif

const GERSTNER_SHARE: f32 = 0.70711; // of `water.slope`: half the variance; shorter waves have the other half

/// One wave.
struct GerstnerWave {
    /// Where it runs to: unit vector (east, south).
    toward: vec2f,
    /// Radians a metre.
    number: f32,
    /// Half its height (m).
    amplitude: f32,
    /// Radians a second.
    pulsation: f32,
    /// Where it is at time 0 (rad).
    phase: f32,
}

/// A particle of the surface.
struct GerstnerPoint {
    /// Where it is, seen from where it rests (m).
    offset: vec3f,
    /// Derivative of its place by its place of rest, to the east.
    eastward: vec3f,
    /// And to the south.
    southward: vec3f,
    /// Slope variance of the waves left out.
    variance: f32,
}

/// ω of waves of number `k` (rad/m) in water `depth` (m) deep: ω² = g k tanh(k depth) (Airy 1845).
fn gerstner_pulsation(k: f32, depth: f32) -> f32 {
    let x = k * depth;
    let shallow = x * (1.0 - x * x * (1.0 / 3.0 - x * x * (2.0 / 15.0))); // GPUs lose digits of small tanh
    return sqrt(9.81 * k * select(tanh(min(x, 20.0)), shallow, x < 0.1));
}

/// Wave number `i`: lengths fall by a factor of 32 over all of them, all are equally steep, headings are spread about the
/// wind's, those of the short ones more.
fn gerstner_wave(i: i32) -> GerstnerWave {
    let bits = pcg(u32(i) + pcg(4099u));
    let part = f32(i) / f32(GERSTNER_WAVES);
    let wave_length = water.wave_length * exp2(-5.0 * part - 0.12 * unit_float(bits));
    let k = 6.2831853 / wave_length;
    let spread = (0.35 + 0.75 * part) * signed_float(pcg(bits));
    let heading = water.wind_heading + spread;
    let steepness = GERSTNER_SHARE * water.slope * sqrt(2.0 / f32(GERSTNER_WAVES)); // k a
    let omega = gerstner_pulsation(k, water.swell_depth);
    let phase = 6.2831853 * unit_float(pcg(bits + 1u));
    return GerstnerWave(vec2f(sin(heading), -cos(heading)), k, steepness / k, omega, phase);
}

/// How wide the particles' circles are over how high, Q: 1 at most, and less where the waves are so steep that they would
/// fold over. Q times the sum of all k a is at most `water.chop`, which is at most 1.
fn gerstner_width() -> f32 {
    let sum = GERSTNER_SHARE * water.slope * sqrt(2.0 * f32(GERSTNER_WAVES));
    return min(water.chop / max(sum, 1e-6), 1.0);
}

/// The particle that rests at `rest` (m), waves narrower than `footprint` (m) left out.
fn gerstner_point(rest: vec2f, footprint: f32) -> GerstnerPoint {
    let width = gerstner_width();
    var seen = GerstnerPoint(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), 0.0);
    for (var i = 0; i < GERSTNER_WAVES; i++) {
        let wave = gerstner_wave(i);
        let presence = wave_presence(6.2831853 / wave.number, footprint);
        let lost = wave.number * wave.amplitude;
        seen.variance += 0.25 * lost * lost * (1.0 - presence * presence);
        if presence <= 0.0 {
            continue;
        }
        let angle = wave.number * dot(wave.toward, rest) - wave.pulsation * frame.time + wave.phase;
        let s = sin(angle);
        let c = cos(angle);
        let high = presence * wave.amplitude;
        let steep = wave.number * high;
        let d = wave.toward;
        seen.offset += high * vec3f(width * d.x * c, s, width * d.y * c);
        seen.eastward += steep * d.x * vec3f(-width * d.x * s, c, -width * d.y * s);
        seen.southward += steep * d.y * vec3f(-width * d.x * s, c, -width * d.y * s);
    }
    return seen;
}

/// The particle that is at `p` (m), found from where it rests by four steps of a fixed-point iteration, which closes in
/// since nothing folds.
fn gerstner_at(p: vec2f, footprint: f32) -> GerstnerPoint {
    var rest = p;
    var seen = GerstnerPoint(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), 0.0);
    for (var i = 0; i < 4; i++) {
        seen = gerstner_point(rest, footprint);
        rest = p - seen.offset.xz;
    }
    return seen;
}

/// The waves at `p` (m); foam where the surface is squeezed together at the crests.
fn gerstner_waves(p: vec2f, footprint: f32) -> Waves {
    let seen = gerstner_at(p, footprint);
    let up = cross(seen.southward, seen.eastward);
    let stretch = max(up.y, 0.02); // area over area at rest
    let whitecap = 1.0 - smoothstep(0.18, 0.42, stretch);
    return Waves(seen.offset.y, -up.xz / stretch, seen.variance, whitecap);
}

/// A height (m) above the level that no crest exceeds, and below it no trough: the sum of all amplitudes, at most.
fn gerstner_reach() -> f32 {
    // The wave lengths fall by 2^5 in all: with eight waves and more their sum is at most .35 of as many of the longest.
    return 0.35 * GERSTNER_SHARE * water.slope * sqrt(2.0 * f32(GERSTNER_WAVES)) * water.wave_length / 6.2831853;
}
