// What running water does to a slope: gullies that follow it, smaller ones running into them, crisp ridges between.
//
// After the idea of the erosion filter (runevision 2024-26): stripes aligned with the slope, blended between jittered
// cells; each generation follows the slope that those before have left. It needs the land at the one point only, so it
// is a pure function of it. With the land's second derivatives its own gradient is exact.

#include <math/jet.wgsl>
#include <noise/pcg.wgsl>

/// How land is eroded. Lengths in the units of the land and its plane, the same for both.
struct Erosion {
    /// Width of the widest gullies, from crest to crest, > 0.
    width: f32,
    /// The most that the land is raised or lowered.
    strength: f32,
    /// Generations of gullies, 0 .. 8; fractional ones fade.
    octaves: f32,
    /// How deep a generation is compared with the one before, 0 < gain < 1.
    gain: f32,
    /// How much finer a generation is than the one before, > 1.
    lacunarity: f32,
    /// The slope (rise over run) that steers the gullies in place of the land's own, which gives but the direction:
    /// the gentler, the more do tributaries leave the fall line. About 1 .. 4 times strength / width.
    assumed_slope: f32,
    /// Land of this slope is eroded half as much as steep land; level land is not. About half the usual slope: less,
    /// and the gullies of both sides of a crest tear it where they meet.
    level_slope: f32,
    /// How round the crests between gullies are: .03 crisp, 1 waves.
    crest_roundness: f32,
    /// How round the bottoms of gullies are: .03 a cut, 1 waves.
    gully_roundness: f32,
    /// Height of the valley floors, where gullies end.
    bottom: f32,
    /// Height of the peaks, where gullies begin; above `bottom`.
    top: f32,
}

const EROSION_MAX_OCTAVES: i32 = 8;
const EROSION_JITTER: f32 = 0.8; // how far over its cell a stripe's middle may lie
const EROSION_REACH2: f32 = 2.56; // squared reach of a cell's stripes: 1.6 cells, so that 4x4 cells are all that count
const EROSION_FLOOR: f32 = 0.35; // coherence, in parts of the full one, below which stripes that cancel stay weak
const EROSION_BLUNT: f32 = 0.1; // squared slope, in parts of the assumed one, under which gullies lose their lead
const EROSION_COLUMNS: vec4f = vec4f(-1.0, 0.0, 1.0, 2.0); // of the cells that count
const EROSION_TAU: f32 = 6.2831853;

/// Two waves a quarter apart, each with its gradient: (value, d/dx, d/dy), |value| <= 1.
struct ErosionWave {
    /// 1 on crests, -1 in gullies.
    even: vec3f,
    /// A quarter of a wave further.
    odd: vec3f,
}

/// Change of the height of `land` at `p` and its exact gradient: (change, d/dx, d/dy), |change| <= how.strength.
///
/// `land`: height, gradient and second derivatives there. The smoother it is on the scale of `how.width`, the better:
/// where the fall line turns about within less, gullies tear; erode few octaves and add the fine ones after.
/// Near `how.top` the land is raised by up to the strength, near `how.bottom` lowered, and so it is on level ground,
/// less in between: toward there the gullies fade. Crests stay where they are whatever the number of octaves.
/// Its slope has no useful bound (the fall line may turn at once where the land is level): a march that must not miss
/// takes the land's bound with how.strength added to its height, or falls back to a tested step. Sixteen cells an
/// octave, of which about half count.
fn erosion2(p: vec2f, land: Jet2, how: Erosion, seed: u32) -> vec3f {
    let bend = mat2x2f(land.hessian.xy, land.hessian.yz);

    // The fall line: at most 1 long, shorter on level land; column i of its derivatives is the one along axis i.
    let shorten = inverseSqrt(dot(land.gradient, land.gradient) + how.level_slope * how.level_slope);
    let fall = shorten * land.gradient;
    let along = fall * bend; // both columns' part along the fall line
    let fall_turn = shorten * mat2x2f(bend[0] - along.x * fall, bend[1] - along.y * fall);
    var slope = how.assumed_slope * fall;
    var slope_turn = how.assumed_slope * fall_turn;

    // What the land is drawn to where no gullies are: up at the top, down at the bottom, nothing half-way.
    let rise = 1.0 / (how.top - how.bottom);
    let h = clamp((land.value - how.bottom) * rise, 0.0, 1.0);
    var rest = vec3f(2.0 * h * h * (3.0 - 2.0 * h) - 1.0, 12.0 * h * (1.0 - h) * rise * land.gradient);
    // Where gullies are: on slopes, away from top and bottom.
    let steep = vec3f(dot(fall, fall), 2.0 * (fall * fall_turn));
    let rest2 = rest.x * rest.x;
    let between = vec3f(1.0 - rest2 * rest2, -4.0 * rest2 * rest.x * rest.yz);
    var hold = vec3f(steep.x * between.x, steep.x * between.yz + between.x * steep.yz);

    var change = vec3f(0.0);
    var cell = how.width;
    var share = 1.0 - how.gain; // of this generation; all together 1
    var left = 1.0; // for the generations still to come
    let blunt = EROSION_BLUNT * how.assumed_slope * how.assumed_slope + 1e-12;
    for (var i = 0; i < EROSION_MAX_OCTAVES; i++) {
        let presence = clamp(how.octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        // Stripes across the slope: the wave vector, per cell, and its derivatives, per unit of p.
        let shorter = inverseSqrt(dot(slope, slope) + blunt);
        let down = shorter * slope;
        let down_along = down * slope_turn;
        let down_x = shorter * (slope_turn[0] - down_along.x * down);
        let down_y = shorter * (slope_turn[1] - down_along.y * down);
        let wave = EROSION_TAU * vec2f(-down.y, down.x);
        let wave_turn = EROSION_TAU * mat2x2f(vec2f(-down_x.y, down_x.x), vec2f(-down_y.y, down_y.x));
        let stripes = erosion_wave(p / cell, wave, cell * wave_turn, seed + u32(i));
        let even = vec3f(stripes.even.x, stripes.even.yz / cell);
        let odd = vec3f(stripes.odd.x, stripes.odd.yz / cell);

        // This generation, and back to `rest` where gullies do not hold.
        let form = erosion_profile(even.x, how.crest_roundness, how.gully_roundness);
        let cut = vec3f(form.x, form.y * even.yz) - rest;
        // Where the generations before have levelled the slope there is no fall line to follow.
        let led = vec3f(dot(down, down), 2.0 * vec2f(dot(down, down_x), dot(down, down_y)));
        let held = vec3f(hold.x * led.x, hold.x * led.yz + led.x * hold.yz);
        let part = presence * held;
        rest += vec3f(part.x * cut.x, part.x * cut.yz + part.yz * cut.x);
        change += share * rest;
        left -= share;

        // The slope that the rounded stripes leave steers the next generation.
        let tilt = -how.strength * share * presence / cell;
        let lean = vec3f(held.x * odd.x, held.x * odd.yz + held.yz * odd.x);
        slope += tilt * lean.x * wave;
        slope_turn += tilt * (lean.x * wave_turn + mat2x2f(lean.y * wave, lean.z * wave));

        // Finer gullies leave the crests and the bottoms of the coarser ones as they are.
        let even2 = even.x * even.x;
        let flank = vec3f(1.0 - even2 * even2, -4.0 * even2 * even.x * even.yz);
        hold = vec3f(hold.x * flank.x, hold.x * flank.yz + flank.x * hold.yz);
        cell /= how.lacunarity;
        share *= how.gain;
    }
    return how.strength * (change + left * rest);
}

/// Weighted sums over cells, each with its gradient: of both waves, and of the weights.
struct ErosionSums {
    even: vec3f,
    odd: vec3f,
    total: vec3f,
}

/// The part of the four cells of a row in the sums. `columns` and `row_hash` are the cells' places as hash input,
/// `offset` is from the middle of cell (0, `row`).
fn erosion_row(columns: vec4u, row_hash: u32, offset: vec2f, wave: vec2f, turn: mat2x2f) -> ErosionSums {
    // Where the cells' stripes have their middles is `pcg2d`, four times.
    var x = columns * 1664525u + 1013904223u;
    var y = vec4u(row_hash * 1664525u + 1013904223u);
    x += y * 1664525u;
    y += x * 1664525u;
    x ^= x >> vec4u(16u);
    y ^= y >> vec4u(16u);
    x += y * 1664525u;
    y += x * 1664525u;
    x ^= x >> vec4u(16u);
    y ^= y >> vec4u(16u);
    let offset_x = offset.x - EROSION_COLUMNS - EROSION_JITTER * (vec4f(x >> vec4u(8u)) / 16777216.0 - 0.5);
    let offset_y = offset.y - EROSION_JITTER * (vec4f(y >> vec4u(8u)) / 16777216.0 - 0.5);
    // Near to exp(-2 d²) - 0.01111, but smooth where it ends.
    let near = max(1.0 - (offset_x * offset_x + offset_y * offset_y) / EROSION_REACH2, vec4f(0.0));
    let near3 = near * near * near;
    let weight = near3 * near;
    let fading_x = (-8.0 / EROSION_REACH2) * near3 * offset_x;
    let fading_y = (-8.0 / EROSION_REACH2) * near3 * offset_y;
    let phase = wave.x * offset_x + wave.y * offset_y;
    let c = cos(phase);
    let s = sin(phase);
    let advance_x = weight * (wave.x + turn[0].x * offset_x + turn[0].y * offset_y); // the wave vector turns while q
    let advance_y = weight * (wave.y + turn[1].x * offset_x + turn[1].y * offset_y); // moves
    return ErosionSums(
        vec3f(dot(weight, c), dot(c, fading_x) - dot(s, advance_x), dot(c, fading_y) - dot(s, advance_y)),
        vec3f(dot(weight, s), dot(s, fading_x) + dot(c, advance_x), dot(s, fading_y) + dot(c, advance_y)),
        vec3f(dot(weight, vec4f(1.0)), dot(fading_x, vec4f(1.0)), dot(fading_y, vec4f(1.0))),
    );
}

/// Stripes at `q`, in cells: waves of the given wave vector through the middles of the cells around, blended.
///
/// `turn`: the wave vector's derivatives, a column an axis of `q`. Sixteen cells, row by row and not in a loop: software
/// GPUs grant an invocation 65,535 turns of loops, and marches spend them.
fn erosion_wave(q: vec2f, wave: vec2f, turn: mat2x2f, seed: u32) -> ErosionWave {
    let lattice = floor(q);
    let t = q - lattice;
    let corner = vec2i(lattice);
    let key = pcg(seed);
    let columns = bitcast<vec4u>(corner.x + vec4i(EROSION_COLUMNS)) + key;
    let row = bitcast<u32>(corner.y) + key;
    let a = erosion_row(columns, row - 1u, t + vec2f(0.0, 1.0), wave, turn);
    let b = erosion_row(columns, row, t, wave, turn);
    let c = erosion_row(columns, row + 1u, t - vec2f(0.0, 1.0), wave, turn);
    let d = erosion_row(columns, row + 2u, t - vec2f(0.0, 2.0), wave, turn);
    let even = a.even + b.even + c.even + d.even;
    let odd = a.odd + b.odd + c.odd + d.odd;
    let total = a.total + b.total + c.total + d.total;
    // Waves of neighbouring cells cancel here and there; make up for most of it, but let a gully end where they do.
    let floor2 = EROSION_FLOOR * EROSION_FLOOR;
    let size = sqrt(even.x * even.x + odd.x * odd.x + floor2 * total.x * total.x);
    let size_slope = (even.x * even.yz + odd.x * odd.yz + floor2 * total.x * total.yz) / size;
    let scale = sqrt(1.0 + floor2) / size;
    let log_slope = size_slope / size;
    return ErosionWave(
        scale * vec3f(even.x, even.yz - even.x * log_slope),
        scale * vec3f(odd.x, odd.yz - odd.x * log_slope),
    );
}

/// The height of a cosine wave of height `x`, its crests and its bottoms sharpened, and the slope of that: -1 .. 1.
fn erosion_profile(x: f32, crest_roundness: f32, gully_roundness: f32) -> vec2f {
    let r = max(vec2f(crest_roundness, gully_roundness), vec2f(0.01));
    // A parabola's square root is a corner: how far below the crest and above the bottom, each 0 .. 1, rounded.
    let root = sqrt(max(vec2f(0.5 - 0.5 * x, 0.5 + 0.5 * x), vec2f(0.0)) + r * r);
    let range = sqrt(1.0 + r * r) - r;
    let height = (root - r) / range;
    let slope = 0.25 / (root * range);
    return vec2f(height.y - height.x, slope.x + slope.y);
}
