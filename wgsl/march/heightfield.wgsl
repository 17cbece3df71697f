// Where a ray meets a heightfield, and how much of the sun is seen from a point on it.

/// Height of the ground (m) at a place of the map (m); details much smaller than `footprint` (m) may be left out.
#slot height: fn(p: vec2f, footprint: f32) -> f32

/// Where a ray ended.
struct Hit {
    /// Distance along the ray (m): to the ground if `hit`, else how far was looked.
    distance: f32,
    /// Whether it met the ground.
    hit: bool,
    /// Height evaluations that it took.
    steps: i32,
}

/// How a march trades speed for misses: step = `shortest` + `growth` · distance + `relax` · height above ground.
struct March {
    /// Shortest step (m).
    shortest: f32,
    /// By how much steps grow with distance, as a part of it.
    growth: f32,
    /// Part of the height above ground that one step may cover: at most the cosine of the steepest slope
    /// misses nothing.
    relax: f32,
    /// Steps at most.
    max_steps: i32,
    /// Halvings of the last step, to find the crossing in it.
    bisections: i32,
    /// Size of a pixel as an angle (rad): what is smaller is not looked for.
    pixel_angle: f32,
}

/// First crossing of the ground along a ray.
///
/// `direction` is a unit vector, `ceiling` (m) a height that the ground nowhere exceeds, `far` (m) how far to look, from
/// above counted from where the ray comes below the ceiling. A ray that starts below the ground ends at once, with
/// distance 0. Coming within half a pixel of the ground counts as meeting it, and so does running out of steps. What
/// may be missed is a thin crest that lies between two steps.
fn march(origin: vec3f, direction: vec3f, ceiling: f32, far: f32, how: March) -> Hit {
    var t = 0.0;
    if direction.y < -1e-6 {
        t = max((ceiling - origin.y) / direction.y, 0.0); // from above: nothing to meet before the ceiling
    } else if origin.y > ceiling {
        return Hit(far, false, 0);
    }
    var end = t + far;
    if direction.y > 1e-6 {
        end = min(end, (ceiling - origin.y) / direction.y);
    }
    var before = t;
    var steps = 0;
    var found = false;
    var above = 0.0;
    for (var i = 0; i < how.max_steps; i++) {
        let p = origin + t * direction;
        above = p.y - height(p.xz, max(t * how.pixel_angle, 0.04 * above)); // high up, small details do not matter
        steps = i + 1;
        if above <= 0.5 * how.pixel_angle * t { // within half a pixel: near enough
            found = true;
            break;
        }
        before = t;
        t += how.shortest + how.growth * t + how.relax * above;
        if t > end {
            return Hit(far, false, steps);
        }
    }
    if !found {
        return Hit(before, true, steps); // out of steps: they are short only where the ray grazes the ground
    }
    var after = t;
    for (var i = 0; i < how.bisections; i++) {
        let middle = 0.5 * (before + after);
        let p = origin + middle * direction;
        if p.y > height(p.xz, middle * how.pixel_angle) {
            before = middle;
        } else {
            after = middle;
        }
    }
    return Hit(after, true, steps + how.bisections);
}

/// Part of a distant light that is seen from `origin`, 0 (umbra) .. 1.
///
/// The least (height above ground) / (distance) along the ray to it, held against the light's size (Quilez):
/// `spread` is its angular radius (rad, > 0). `start` and `far` (m) are where to begin and to give up, `max_steps`
/// how often to look; steps grow with distance, and so does the size of the details looked at. The least is then
/// searched for between the looks (golden section), or the crests' shadows would have teeth.
fn shadow(
    origin: vec3f,
    to_light: vec3f,
    spread: f32,
    start: f32,
    far: f32,
    ceiling: f32,
    footprint: f32,
    max_steps: i32,
) -> f32 {
    if to_light.y <= -spread {
        return 0.0;
    }
    var end = far;
    if to_light.y > 1e-6 {
        end = min(far, (ceiling - origin.y) / to_light.y);
    }
    let growth = pow(max(far / start, 2.0), 1.0 / f32(max_steps)); // geometric: as many looks near as far
    var least = 1e9;
    var low = start; // the least lies between these two
    var high = start;
    var newest = false;
    var before = start;
    var t = start;
    for (var i = 0; i < max_steps; i++) {
        if t > end || least < -1.0 {
            break;
        }
        let above = clearance(origin, to_light, t, footprint);
        let here = above / (t * spread);
        if newest {
            high = t;
        }
        newest = here < least;
        if newest {
            least = here;
            low = before;
            high = t;
        }
        before = t;
        t = max(t * growth, t + 0.4 * above);
    }
    if newest {
        high = min(t, end);
    }
    if least > -1.0 && high > low {
        const GOLDEN: f32 = 0.618034;
        var a = high - GOLDEN * (high - low);
        var b = low + GOLDEN * (high - low);
        var at_a = 0.0;
        var at_b = 0.0;
        for (var i = 0; i < 8; i++) {
            var left = i == 0; // the first two looks are at a and at b
            if i >= 2 {
                left = at_a < at_b;
                if left {
                    high = b;
                    b = a;
                    at_b = at_a;
                    a = high - GOLDEN * (high - low);
                } else {
                    low = a;
                    a = b;
                    at_a = at_b;
                    b = low + GOLDEN * (high - low);
                }
            }
            t = select(b, a, left);
            let here = clearance(origin, to_light, t, footprint) / (t * spread);
            at_a = select(at_a, here, left);
            at_b = select(here, at_b, left);
            least = min(least, here);
        }
    }
    return smoothstep(-1.0, 1.0, least);
}

/// Height (m) of a ray above the ground at `t` (m); the farther, the coarser the ground.
fn clearance(origin: vec3f, direction: vec3f, t: f32, footprint: f32) -> f32 {
    let p = origin + t * direction;
    return p.y - height(p.xz, max(footprint, 0.01 * t));
}
