// Where rays truly meet the land, found by a march so dense that it misses next to nothing.

#include <terrain/height.wgsl>
#include <terrain/shade.wgsl>

/// Which land is the truth: without the details that are too small for the pixel, as the scene marches it, or with all.
#option inspect.detail = pixel { pixel, full }
/// Part of the height above ground that a step of the dense march covers: at 0.1 it misses nothing less steep than 84°.
#param inspect.truth_relax: f32 = 0.1, range 0.001 .. 1
/// Shortest step of the dense march, in pixels.
#param inspect.truth_grain: f32 = 0.25, range 0.001 .. 10
/// Steps of the dense march at most.
#option inspect.truth_steps = 4096, range 64 .. 65536

/// What is true of a ray.
struct Truth {
    /// Whether the march came to an end within its steps.
    known: bool,
    /// Whether the ray meets the land.
    hit: bool,
    /// Where (m).
    distance: f32,
}

/// Height of the land (m) at `p` (m) that counts as true for a pixel at `distance` (m).
fn inspect_true_height(p: vec2f, distance: f32) -> f32 {
#if inspect.detail == full
    return terrain_height(p);
#else
    return terrain_height_filtered(p, terrain_footprint(distance));
#endif
}

/// Where the ray from `origin` (m) in the unit `direction` first meets the land, looked for as far as the scene looks.
///
/// Costly: hundreds of heights, up to `inspect.truth_steps`.
fn inspect_truth(origin: vec3f, direction: vec3f) -> Truth {
    let ceiling = terrain_ceiling();
    var t = 0.0;
    if direction.y < -1e-6 {
        t = max((ceiling - origin.y) / direction.y, 0.0);
    } else if origin.y > ceiling {
        return Truth(true, false, terrain.far);
    }
    var end = t + terrain.far;
    if direction.y > 1e-6 {
        end = min(end, (ceiling - origin.y) / direction.y);
    }
    var before = t;
    var after = -1.0;
    for (var i = 0; i < inspect.truth_steps + 24; i++) {
        // Past the crossing, the last step is halved: one loop, so that there is one copy of the land in it.
        let is_found = after >= 0.0;
        let at = select(t, 0.5 * (before + after), is_found);
        let p = origin + at * direction;
        let above = p.y - inspect_true_height(p.xz, at);
        if is_found {
            if above > 0.0 {
                before = at;
            } else {
                after = at;
            }
            if after - before <= 1e-6 * after {
                break;
            }
        } else if above <= 0.0 {
            after = at;
            if at <= before {
                break; // it starts below the ground
            }
        } else {
            before = at;
            t = at + inspect.truth_grain * max(terrain_footprint(at), 0.01) + inspect.truth_relax * above;
            if t > end {
                return Truth(true, false, terrain.far);
            }
        }
    }
    return Truth(after >= 0.0, after >= 0.0, after);
}
