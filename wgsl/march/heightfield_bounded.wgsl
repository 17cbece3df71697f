// A ray against a heightfield that is a sum of octaves: conservative, so that nothing is ever missed.
//
// Each octave keeps a model of itself along the ray: its value and slope where it was last evaluated. From these and
// from the suprema of the noise follows how high it can stand anywhere else on the ray, and the ray is free up to where
// the sum of these bounds meets it. One octave is evaluated a step: the one that is known worst. Coarse octaves vary
// slowly and are asked rarely, fine ones only near the ground. (Of the family of Galin et al. 2020, "Segment Tracing
// Using Local Lipschitz Bounds".)

#include <march/hit.wgsl>

/// Octave `index` at `p` (m): its height (m) and its slope along both axes.
#slot octave: fn(p: vec2f, index: i32) -> vec3f

/// What octave `index` nowhere exceeds in size: height (m), slope in any direction, curvature in any direction (1/m).
///
/// A slope of which only tests know is as good as those tests. Where there is no bound of the curvature, 1e20.
#slot octave_bounds: fn(index: i32) -> vec3f

/// Where the first octaves add up to `height` (m): the part that the others count there, 0 .. 1, which must not fall as
/// `height` rises, and how fast it rises at most (1/m).
///
/// (1, 0) is the plain sum; the normalised height makes the dual heightmap.
#slot ruggedness: fn(height: f32) -> vec2f

const BOUNDED_MAX_OCTAVES: i32 = 16;
const BOUNDED_AHEAD: f32 = 0.03; // part of the clearance that an octave's error may take up where the ray is now

/// What the march is to look for.
struct Bounded {
    /// Octaves, 1 .. 16; the last one in part if fractional.
    octaves: f32,
    /// How many of them, from the first on, make the height that `ruggedness` is asked for; all of them for a plain sum.
    plain: i32,
    /// Wavelength of the first octave (m).
    wavelength: f32,
    /// How many times finer an octave is than the one before, > 1.
    lacunarity: f32,
    /// Size of a pixel as an angle (rad): octaves finer than a pixel fade out, in rings of half an octave, and the
    /// tolerance grows by a tenth of a pixel. 0: neither.
    pixel_angle: f32,
    /// Clearance (m) that counts as none.
    tolerance: f32,
    /// Steps at most; a few hundred are enough for all but rays that graze the ground for kilometres.
    max_steps: i32,
}

/// First crossing of the ground along a ray.
///
/// `direction` is a unit vector. Looks from `start` to `far` (m). The ray has met the ground where it is less than the
/// tolerance above it, which is `tolerance` and what f32 rounds at that distance; from there the crossing is found
/// along the slope. Between `start` and the distance returned the ray is nowhere below the ground (as far as `octave_bounds` holds), and
/// a crossing is never passed over. Running out of steps counts as meeting it. A ray that starts below the ground ends
/// at once. `evaluations` are of single octaves.
fn march(origin: vec3f, direction: vec3f, start: f32, far: f32, how: Bounded) -> MarchHit {
    let octaves = clamp(how.octaves, 0.0, f32(BOUNDED_MAX_OCTAVES));
    let count = i32(ceil(octaves));
    let across = length(direction.xz); // metres of the map a metre of the ray
    var suprema: array<vec3f, BOUNDED_MAX_OCTAVES>; // along the ray
    var models: array<vec3f, BOUNDED_MAX_OCTAVES>; // where on the ray, value and slope there
    var ceiling = 0.0;
    var rugged_ceiling = 0.0;
    var steepest = 1.0;
    for (var i = 0; i < count; i++) {
        let bounds = octave_bounds(i);
        let presence = min(octaves - f32(i), 1.0);
        // No less than what keeps an unknown octave (below) at its highest, also straight down.
        suprema[i] = max(bounds * vec3f(1.0, across, across * across), (bounds.x + 1e-6) * vec3f(1.0, 1e-6, 1e-12));
        models[i] = vec3f(-1e9, 0.0, 0.0); // unknown: taken very far away
        ceiling += presence * bounds.x;
        rugged_ceiling += select(0.0, presence * bounds.x, i >= how.plain);
        steepest += presence * bounds.y;
    }

    var t = max(start, 0.0);
    if direction.y < -1e-6 {
        t = max(t, (ceiling - origin.y) / direction.y); // nothing to meet above the ceiling
    } else if origin.y + t * direction.y > ceiling {
        return MarchHit(far, false, 0, 0);
    }
    var end = far;
    if direction.y > 1e-6 {
        end = min(end, (ceiling - origin.y) / direction.y);
    }
    var asked = -1; // the octave asked last, and where
    var asked_at = -1.0;
    for (var steps = 0; steps < how.max_steps; steps++) {
        if t > end {
            return MarchHit(far, false, steps, steps);
        }
        let level = detail(t, octaves, how);
        // How high the octaves can stand here, how fast that can grow, and which of them is known worst.
        var plain = vec4f(0.0);
        var rugged = vec4f(0.0);
        var plain_error = 0.0;
        var rugged_error = 0.0;
        var closing = -direction.y;
        var worst = 0;
        var worst_error = -1.0;
        for (var i = 0; i < count; i++) {
            let presence = clamp(level.x - f32(i), 0.0, 1.0);
            let offset = t - models[i].x;
            let bound = presence * octave_bound(models[i], suprema[i], offset);
            let s = abs(offset);
            let error = presence * min(s * min(0.5 * suprema[i].z * s, suprema[i].y), suprema[i].x);
            if i < how.plain {
                plain += bound;
                plain_error += error;
            } else {
                rugged += bound;
                rugged_error += error;
            }
            closing += presence * models[i].z;
            if error > worst_error {
                worst_error = error;
                worst = i;
            }
        }
        let at = origin + t * direction;
        var part = ruggedness(plain.x);
        let lever = 1.0 + part.y * rugged_ceiling; // what the first octaves lift, they also make more rugged
        let error = lever * plain_error + part.x * rugged_error;
        let above = at.y - plain.x - part.x * max(rugged.x, 0.0);
        let rounding = 2.5e-7 * steepest * (abs(at.x) + abs(at.y) + abs(at.z));
        let tolerance = max(how.tolerance + 0.1 * how.pixel_angle * t, 2.0 * rounding);
        if above + 2.0 * error <= tolerance {
            let beyond = max(above + error, 0.0) / max(closing, 0.25 * tolerance);
            return MarchHit(t + min(beyond, 4.0 * tolerance), true, steps, steps);
        }

        // Ask the worst octave, a little ahead: its model then serves on both sides.
        let limits = suprema[worst];
        let reach = sqrt(2.0 * BOUNDED_AHEAD * max(above + error, 0.0) / limits.z);
        let near_enough = worst != asked || t != asked_at;
        let place = t + select(0.0, min(reach, 0.9 * limits.x / limits.y), near_enough);
        asked = worst;
        asked_at = t;
        let answer = octave((origin + place * direction).xz, worst);
        let model = vec3f(place, answer.x, dot(answer.yz, direction.xz));
        let before = octave_bound(models[worst], limits, t - models[worst].x);
        let gain = clamp(level.x - f32(worst), 0.0, 1.0) * (octave_bound(model, limits, t - place) - before);
        models[worst] = model;
        if worst < how.plain {
            plain += gain;
            part = ruggedness(plain.x);
        } else {
            rugged += gain;
        }

        // As far as it is free for sure: where a parabola of the greatest curvature could meet the ray, or a line of the
        // steepest slope, whichever is farther.
        let clear = at.y - plain.x - part.x * max(rugged.x, 0.0) - 0.5 * tolerance;
        if clear > 0.0 {
            let growth = select(plain.y, lever * plain.y, plain.y > 0.0) + part.x * rugged.y - direction.y;
            let curvature = lever * plain.z + part.x * rugged.z;
            let fastest = lever * plain.w + part.x * rugged.w - direction.y;
            let slow = growth + sqrt(growth * growth + 2.0 * curvature * clear);
            let by_curvature = select(1e30, 2.0 * clear / slow, slow > 1e-20);
            let by_slope = select(1e30, clear / fastest, fastest > 1e-20);
            t = min(t + max(by_curvature, by_slope), level.y);
        }
    }
    return MarchHit(t, true, how.max_steps, how.max_steps);
}

/// How many octaves are not finer than a pixel at `t` (m), in halves, and up to where that many are taken (m).
fn detail(t: f32, octaves: f32, how: Bounded) -> vec2f {
    if how.pixel_angle <= 0.0 {
        return vec2f(octaves, 1e30);
    }
    let per_octave = log2(how.lacunarity);
    let coarsest = how.wavelength / how.pixel_angle; // where the first octave is as fine as a pixel (m)
    let fitting = min(max(log2(coarsest / max(t, 1e-6)) / per_octave + 1.0, 1.0), octaves);
    let level = ceil(2.0 * fitting) * 0.5;
    let ring = coarsest * exp2((1.5 - level) * per_octave) * 1.000001;
    return vec2f(min(level, octaves), select(1e30, ring, level > 1.0 && ring > t));
}

/// How high an octave can stand `offset` (m) from where its model was taken, how fast that can grow onward, how bent
/// that growth can be, and its steepest slope: 0 for those three where it stands as high as it ever can.
fn octave_bound(model: vec3f, suprema: vec3f, offset: f32) -> vec4f {
    let s = abs(offset);
    let onward = offset >= 0.0;
    let outward = select(-model.z, model.z, onward); // slope away from the model
    let bent = clamp((suprema.y - outward) / suprema.z, 0.0, s); // as far as it can become ever steeper
    let reached = outward + suprema.z * bent;
    let height = model.y + bent * (outward + 0.5 * suprema.z * bent) + suprema.y * (s - bent);
    if height >= suprema.x {
        return vec4f(suprema.x, 0.0, 0.0, 0.0);
    }
    let curvature = select(0.0, suprema.z, bent >= s || !onward);
    return vec4f(height, select(-reached, reached, onward), curvature, suprema.y);
}
