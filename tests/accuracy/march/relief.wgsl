// The land of the march's tests and bench: octaves of Perlin noise, each turned and shifted. What it is like
// (RELIEF_…) is written above this by whoever uses it.

#include <noise/perlin.wgsl>
#include <march/heightfield_adaptive.wgsl> as adaptive with height = relief_height
#include <march/heightfield_bounded.wgsl> as bounded with octave = relief_octave, octave_bounds = relief_bounds, ruggedness = relief_sum
#include <march/heightfield_fixed.wgsl> as fixed with height = relief_height
#include <march/heightfield_relaxed.wgsl> as relaxed with height = relief_height

// Powers of the turn by 36.87 degrees.
const RELIEF_TURNS: array<vec2f, 10> = array<vec2f, 10>(vec2f(1.000000000, 0.000000000), vec2f(0.800000000, 0.600000000), vec2f(0.280000000, 0.960000000), vec2f(-0.352000000, 0.936000000), vec2f(-0.843200000, 0.537600000), vec2f(-0.997120000, -0.075840000), vec2f(-0.752192000, -0.658944000), vec2f(-0.206387200, -0.978470400), vec2f(0.421972480, -0.906608640), vec2f(0.881543168, -0.472103424));

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
    return RELIEF_HEIGHT * pow(RELIEF_GAIN, f32(index)) * vec3f(1.0, 2.927 * frequency, 13.07 * frequency * frequency);
}

fn relief_sum(height: f32) -> vec2f {
    return vec2f(1.0, 0.0);
}

fn relief_height(p: vec2f, footprint: f32) -> f32 {
    var sum = 0.0;
    for (var i = 0; i < RELIEF_OCTAVES; i++) {
        sum += relief_octave(p, i).x;
    }
    return sum;
}

fn relief_bounded(tolerance: f32) -> bounded_Bounded {
    return bounded_Bounded(f32(RELIEF_OCTAVES), RELIEF_OCTAVES, RELIEF_WAVELENGTH, 2.0, 0.0, tolerance, 600);
}
