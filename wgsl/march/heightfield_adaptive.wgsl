// A ray against a heightfield in steps that adapt to distance and to the height above ground.

#include <march/hit.wgsl>

/// Height of the ground (m) at a place of the map (m); details much smaller than `footprint` (m) may be left out.
#slot height: fn(p: vec2f, footprint: f32) -> f32

/// How a march trades speed for misses: step = `shortest` + `growth` · distance + `relax` · height above ground.
struct Adaptive {
    /// Shortest step (m).
    shortest: f32,
    /// By how much steps grow with distance, as a part of it.
    growth: f32,
    /// Part of the height above ground that one step may cover: 1 / (steepest slope + steepest ray) misses nothing.
    relax: f32,
    /// Steps at most.
    max_steps: i32,
    /// Halvings of the last step, to find the crossing in it.
    bisections: i32,
    /// Size of a pixel as an angle (rad): half a pixel above ground counts as meeting it, and details finer than a
    /// pixel need not be there. May be 0.
    pixel_angle: f32,
}

/// First crossing of the ground along a ray.
///
/// `direction` is a unit vector, `ceiling` (m) a height that the ground nowhere exceeds, `far` (m) how far to look,
/// from above counted from where the ray comes below the ceiling. A ray that starts below the ground ends at once, with
/// distance 0. Where steps run out, they grow to reach the end: they are short only where the ray grazes the ground. What
/// is missed is a crest that lies between two steps: tested, not proven. After the halvings the crossing is where a line
/// through both ends of what is left meets the ground.
fn march(origin: vec3f, direction: vec3f, ceiling: f32, far: f32, how: Adaptive) -> MarchHit {
    return approach(origin, direction, ceiling, far, 0.0, how).hit;
}

/// As `march`; and how far the ray stays `clearance` (m) or more above ground, as its steps saw it: what stands on the
/// ground needs to be looked for only from there on. A ray that meets nothing and is never so low is clear up to `far`, as if
/// nothing stood on ground that is as high as the ceiling.
fn approach(origin: vec3f, direction: vec3f, ceiling: f32, far: f32, clearance: f32, how: Adaptive) -> MarchApproach {
    var t = 0.0;
    if direction.y < -1e-6 {
        t = max((ceiling - origin.y) / direction.y, 0.0); // from above: nothing to meet before the ceiling
    } else if origin.y > ceiling {
        return MarchApproach(MarchHit(far, false, 0, 0), 0.0);
    }
    var end = t + far;
    if direction.y > 1e-6 {
        end = min(end, (ceiling - origin.y) / direction.y);
    }
    // The search and the halvings share the one call of `height`: what is costly is compiled once.
    var low = t; // above ground
    var high = t;
    var above_low = 0.0;
    var above_high = 0.0;
    var found = false;
    var halvings = 0;
    var above = 0.0;
    var clear = 0.0;
    var clears = true; // so far
    for (var steps = 0; steps < how.max_steps + how.bisections; steps++) {
        let p = origin + t * direction;
        above = p.y - height(p.xz, max(t * how.pixel_angle, 0.04 * above * f32(how.pixel_angle > 0.0)));
        clears = clears && above >= clearance;
        clear = select(clear, t, clears);
        let under = above <= 0.5 * how.pixel_angle * t;
        if under {
            high = t;
            above_high = above;
        } else {
            low = t;
            above_low = above;
        }
        if found {
            halvings++;
        } else if under {
            found = true;
            if low == high {
                return MarchApproach(MarchHit(t, true, steps + 1, steps + 1), clear);
            }
        } else {
            let left = f32(how.max_steps - steps);
            let rest = (end - t) * min(3.0 / (left * left), 1.0); // the last steps reach the end
            t += max(how.shortest + how.growth * t + how.relax * above, rest);
            if t > end {
                return MarchApproach(MarchHit(far, false, steps + 1, steps + 1), select(clear, far, clears));
            }
            if steps + 1 >= how.max_steps {
                return MarchApproach(MarchHit(low, true, steps + 1, steps + 1), clear);
            }
        }
        if found {
            if halvings >= how.bisections {
                let part = above_low / max(above_low - above_high, 1e-20);
                let met = mix(low, high, clamp(part, 0.0, 1.0));
                return MarchApproach(MarchHit(met, true, steps + 1, steps + 1), clear);
            }
            t = 0.5 * (low + high);
        }
    }
    return MarchApproach(MarchHit(low, true, how.max_steps, how.max_steps), clear);
}
