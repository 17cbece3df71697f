// A ray against a globe's ground: heights above a sphere, seen from space down to a walker's eye.

#include <geometry/globe.wgsl>
#include <march/hit.wgsl>

/// Height (m) of a point above the ground beneath it; details much smaller than `footprint` (m) may be left out.
#slot above: fn(p: vec3f, footprint: f32) -> f32

/// How a march over a globe trades speed for misses: step = `shortest` + `growth` · distance + `relax` · height above ground.
struct Steps {
    /// Shortest step (m).
    shortest: f32,
    /// By how much steps grow with distance, as a part of it.
    growth: f32,
    /// Part of the height above ground that one step may cover.
    relax: f32,
    /// Steps at most.
    max_steps: i32,
    /// Tries to find the crossing in the last step.
    refinements: i32,
    /// Size of a pixel as an angle (rad): details finer than a pixel need not be there, half a pixel above ground counts
    /// as meeting it.
    pixel_angle: f32,
}

/// First crossing of the ground along a ray, no farther than `far` (m), on the globe of `radius` (m) whose ground is nowhere
/// higher than `ceiling` (m) above it.
///
/// Marches from where the ray comes below the ceiling; a ray that starts below the ground ends at once. A ray that runs out of
/// steps meets the ground where it would if that went on at the height it has there. A crest that lies between two steps is
/// missed: tested, not proven. The crossing is sought by regula falsi (Illinois), which has nearly a digit a try where the
/// ground is even.
fn march(origin: vec3f, direction: vec3f, radius: f32, ceiling: f32, far: f32, how: Steps) -> MarchHit {
    let within = globe_span(origin, direction, radius, ceiling);
    if within.far <= 0.0 || within.near > within.far {
        return MarchHit(far, false, 0, 0);
    }
    let end = min(far, within.far);
    var t = max(within.near, 0.0);
    var low = t; // above ground
    var high = t;
    var above_low = 0.0;
    var above_high = 0.0;
    var found = false;
    var tries = 0;
    for (var steps = 0; steps < how.max_steps + how.refinements; steps++) {
        if t > end {
            return MarchHit(far, false, steps, steps);
        }
        let pixel = how.pixel_angle * t;
        let height = above(origin + t * direction, pixel);
        let under = height <= 0.5 * pixel;
        if found {
            tries++;
            // Illinois: the end that stays has its height halved.
            if under {
                high = t;
                above_high = height;
                above_low *= 0.5;
            } else {
                low = t;
                above_low = height;
                above_high *= 0.5;
            }
        } else if under {
            high = t;
            above_high = height;
            if low == high {
                return MarchHit(t, true, steps + 1, steps + 1);
            }
            found = true;
        } else {
            low = t;
            above_low = height;
            t += how.shortest + how.growth * t + how.relax * height;
            if steps + 1 >= how.max_steps {
                let last = origin + low * direction;
                let ahead = globe_span(last, direction, radius, globe_height(last, radius) - height);
                let meets = low + max(ahead.near, 0.0);
                let hit = ahead.near <= ahead.far && ahead.far > 0.0 && meets <= far;
                return MarchHit(select(far, meets, hit), hit, steps + 1, steps + 1);
            }
            if t > end && low < end && end < within.far {
                t = end; // the last look, where the ray is to end
            }
        }
        if found {
            let part = above_low / max(above_low - above_high, 1e-20);
            t = mix(low, high, clamp(part, 0.02, 0.98));
            if tries >= how.refinements || high - low <= 0.05 * pixel || abs(height) < 0.05 * pixel {
                return MarchHit(t, true, steps + 1, steps + 1);
            }
        }
    }
    return MarchHit(low, true, how.max_steps, how.max_steps);
}

/// Part of a distant light that is seen from `origin`, 0 .. 1: the least (height above ground) / (distance) on the way to it,
/// held against the light's angular radius `spread` (rad, > 0).
///
/// Looks `looks` times between `start` and `far` (m), ever farther apart, at ground ever coarser.
fn shadow(
    origin: vec3f,
    to_light: vec3f,
    spread: f32,
    start: f32,
    far: f32,
    footprint: f32,
    looks: i32,
) -> f32 {
    let growth = pow(max(far / start, 2.0), 1.0 / f32(max(looks, 1)));
    var t = start;
    var least = 1.0;
    for (var i = 0; i < looks; i++) {
        let height = above(origin + t * to_light, max(footprint, 0.25 * (growth - 1.0) * t));
        least = min(least, height / (t * spread));
        if least < -1.0 {
            break;
        }
        t = max(t * growth, t + 0.5 * height);
    }
    return smoothstep(-1.0, 1.0, least);
}
