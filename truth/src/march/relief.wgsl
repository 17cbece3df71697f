// A land to march over: octaves of Perlin noise, each turned and shifted. What it is like (RELIEF_…) is written above
// this.

#include <noise/perlin.wgsl>
#include <march/heightfield_adaptive.wgsl> as adaptive with height = relief_height
#include <march/heightfield_bounded.wgsl> as bounded with octave = relief_octave, octave_bounds = relief_bounds, ruggedness = relief_ruggedness
#include <march/heightfield_fixed.wgsl> as fixed with height = relief_height
#include <march/heightfield_relaxed.wgsl> as relaxed with height = relief_height
#include <march/shadow.wgsl> as land with height = relief_height

// Powers of the turn by 36.87 degrees.
const RELIEF_TURNS: array<vec2f, 10> = array<vec2f, 10>(
    vec2f(1.0, 0.0),
    vec2f(0.8, 0.6),
    vec2f(0.28, 0.96),
    vec2f(-0.352, 0.936),
    vec2f(-0.8432, 0.5376),
    vec2f(-0.99712, -0.07584),
    vec2f(-0.752192, -0.658944),
    vec2f(-0.2063872, -0.9784704),
    vec2f(0.42197248, -0.90660864),
    vec2f(0.881543168, -0.472103424),
);

fn relief_octave(p: vec2f, index: i32) -> vec3f {
    let turn = RELIEF_TURNS[index];
    let frequency = exp2(f32(index)) / RELIEF_WAVELENGTH;
    let strength = RELIEF_HEIGHT * pow(RELIEF_GAIN, f32(index));
    let q = frequency * vec2f(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
    let n = perlin_noise2_grad(q + f32(index) * vec2f(37.31, 17.83), u32(index) + 11u);
    let slope = frequency * vec2f(turn.x * n.y + turn.y * n.z, turn.x * n.z - turn.y * n.y);
    return strength * vec3f(n.x, slope);
}

fn relief_bounds(index: i32) -> vec3f {
    let frequency = exp2(f32(index)) / RELIEF_WAVELENGTH;
    return RELIEF_HEIGHT * pow(RELIEF_GAIN, f32(index)) * vec3f(
        PERLIN_NOISE2_RANGE,
        PERLIN_NOISE2_SLOPE * frequency,
        PERLIN_NOISE2_CURVATURE * frequency * frequency,
    );
}

// From valley to height, the octaves after the first RELIEF_PLAIN count for more.
fn relief_ruggedness(height: f32) -> vec2f {
    if RELIEF_PLAIN >= RELIEF_OCTAVES {
        return vec2f(1.0, 0.0);
    }
    return vec2f(clamp(0.5 + 0.5 * height / RELIEF_HEIGHT, 0.0, 1.0), 0.5 / RELIEF_HEIGHT);
}

fn relief_height(p: vec2f, footprint: f32) -> f32 {
    var plain = 0.0;
    var rugged = 0.0;
    for (var i = 0; i < RELIEF_OCTAVES; i++) {
        let height = relief_octave(p, i).x;
        plain += select(0.0, height, i < RELIEF_PLAIN);
        rugged += select(height, 0.0, i < RELIEF_PLAIN);
    }
    return plain + relief_ruggedness(plain).x * rugged;
}

fn relief_bounded(tolerance: f32, pixel_angle: f32) -> bounded_Bounded {
    return bounded_Bounded(
        f32(RELIEF_OCTAVES), RELIEF_PLAIN, RELIEF_WAVELENGTH, 2.0, pixel_angle, tolerance, 800,
    );
}
