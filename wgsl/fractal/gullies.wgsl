// What running water does to a slope: gullies that follow it, with smaller gullies running into them.
//
// After the idea of the erosion filter (runevision 2024-26): waves whose crests run down the slope, blended between
// the jittered cells of a grid. It needs the height's gradient at the one point only, so it is a pure function of
// it.

#include <noise/pcg.wgsl>

const GULLY_RADIUS2: f32 = 1.5625; // squared reach of a cell's wave: 1.25 cells, so that 3x3 cells are all that count

/// One generation of gullies in the plane `p`, a cell of the grid being 1 wide and about one gully wide.
///
/// `side`: unit vector across the slope. Returns (value, slope along `side`), value -1 (bottom) .. 1 (crest).
/// `sharpness`: 0 round crests, 1 sharp ones. The slope is that of the round ones and leaves out that the blend
/// varies: it is there to lead the next generation, which would tear where the slope jumps. Nine cells.
fn gully_wave(p: vec2f, side: vec2f, sharpness: f32, seed: u32) -> vec2f {
    let lattice = floor(p);
    let t = p - lattice;
    let cell = vec2i(lattice);
    let key = pcg(seed);
    let wave = 6.2831853 * side;
    var sum = vec2f(0.0);
    var weights = 0.0;
    for (var j = -1; j <= 1; j++) {
        for (var i = -1; i <= 1; i++) {
            let bits = pcg2d(bitcast<vec2u>(cell + vec2i(i, j)) + key);
            let jitter = 0.5 * unit_float2(bits) - 0.25;
            let offset = t - vec2f(f32(i), f32(j)) - 0.5 - jitter;
            let near = max(1.0 - dot(offset, offset) / GULLY_RADIUS2, 0.0);
            let weight = near * near;
            let phase = dot(offset, wave);
            sum += weight * vec2f(cos(phase), sin(phase));
            weights += weight;
        }
    }
    // The waves of neighbouring cells cancel here and there; make up for most of it, but let a gully end where
    // they do.
    let c = sum / max(length(sum), 0.35 * max(weights, 1e-6));
    let sharp = 1.0 - 2.0 * sqrt(max(0.5 - 0.5 * c.x, 0.0) + 0.02);
    return vec2f(mix(c.x, sharp, sharpness), -6.2831853 * c.y);
}

/// Gullies of several generations on a slope: (change of height, change of the slope), in the units of `p`.
///
/// `slope`: the land's gradient at `p` without gullies, rise over run; the smoother it varies, the better. `width`: of
/// the widest gullies. `depth`: between crest and bottom of those, on ground steeper than `full_slope` > 0; none where
/// it is less than a fifth as steep. Each generation is `gain` as deep and half as wide as the one before, and follows
/// the slope that those before have left. `octaves` may be fractional, 0 .. 8. The change stays within
/// +-`depth` / 2 · (1 + gain + gain² + …). Nine cells an octave.
fn gullies2(
    p: vec2f,
    slope: vec2f,
    width: f32,
    depth: f32,
    full_slope: f32,
    octaves: f32,
    gain: f32,
    seed: u32,
) -> vec3f {
    var change = vec3f(0.0);
    var cell = width;
    var strength = 0.5 * depth;
    for (var i = 0; i < 8; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let downhill = slope + change.yz;
        let steepness = length(downhill);
        let side = vec2f(-downhill.y, downhill.x) / max(steepness, 1e-6);
        let hold = smoothstep(0.2 * full_slope, full_slope, steepness); // on level ground there is no downhill
        let wave = gully_wave(p / cell, side, 0.6, seed + u32(i));
        change += presence * strength * hold * vec3f(wave.x, wave.y * side / cell);
        cell *= 0.5;
        strength *= gain;
    }
    return change;
}
