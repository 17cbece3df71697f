// How large the forms of a planet's ground are, whatever shaped them.

#include <math/precise.wgsl>
#include <noise/perlin.wgsl>

/// Which planet of its kind: another seed, another planet.
#param planet.seed: u32 = 1
/// Width of the largest forms.
#param planet.scale: f32 = 6000000.0, range 1000 .. 100000000, log, unit m
/// How often the width of the forms is halved: the finest are `planet.scale` / 2^`planet.octaves` wide. Those too small to
/// see in a pixel are left out.
#param planet.octaves: u32 = 22, range 4 .. 24
/// Height of the highest mountains above sea level, near enough.
#param planet.peak_height: f32 = 8000.0, range 0 .. 50000, unit m
/// How high the largest forms are, above or below the mean.
#param planet.swell: f32 = 1500.0, range 0 .. 20000, unit m
/// How far the map is bent before it is read, as a part of the width of its largest forms: folded coasts.
#param planet.bend: f32 = 0.15, range 0 .. 1
/// Strength of an octave over that of the next coarser one: the roughness of the mountains.
#param planet.gain: f32 = 0.52, range 0.2 .. 0.8

/// Width of the finest forms (m): the unit of precise places.
fn planet_grain() -> f32 {
    return planet.scale * exp2(-f32(planet.octaves));
}

/// Noise `i` of a map at `place` (grains), its forms 2^`level` grains wide: (value -1 .. 1, slope per grain along x and y).
fn forms_octave(place: Precise, level: i32, i: i32) -> vec3f {
    let scaled = precise_coarser(place, u32(level));
    let shift = f32(i) * vec2f(7.31, 3.83);
    let n = perlin_noise2_at_grad(scaled.cell.xy, scaled.fraction.xy + shift, planet.seed + u32(i));
    return vec3f(n.x, exp2(-f32(level)) * n.yz);
}
