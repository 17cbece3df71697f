// A ray against a heightfield in steps as long as a part of the height above ground: as spheres are traced.

#include <march/hit.wgsl>

/// Height of the ground (m) at a place of the map (m); details much smaller than `footprint` (m) may be left out.
#slot height: fn(p: vec2f, footprint: f32) -> f32

/// First place along a ray that is hardly above the ground: less than `error` times its distance, and `nearest` (m).
///
/// `direction` is a unit vector, `ceiling` (m) a height that the ground nowhere exceeds, `far` (m) how far from
/// the origin to look.
/// `relax`: part of the height above ground that one step covers; 1 / (steepest slope + steepest ray) misses nothing,
/// more than that skips thin crests. `error` is the part of a metre by which a hit may float a metre away: a pixel's
/// angle, say. Running out of steps counts as meeting the ground. Where it has stepped below the ground, it goes back
/// by the depth.
fn march(
    origin: vec3f,
    direction: vec3f,
    ceiling: f32,
    far: f32,
    relax: f32,
    error: f32,
    nearest: f32,
    max_steps: i32,
) -> MarchHit {
    var t = 0.0;
    if direction.y < -1e-6 {
        t = max((ceiling - origin.y) / direction.y, 0.0);
    } else if origin.y > ceiling {
        return MarchHit(far, false, 0, 0);
    }
    var end = far;
    if direction.y > 1e-6 {
        end = min(end, (ceiling - origin.y) / direction.y);
    }
    for (var i = 0; i < max_steps; i++) {
        if t > end {
            return MarchHit(far, false, i, i);
        }
        let p = origin + t * direction;
        let above = p.y - height(p.xz, t * error);
        if above <= max(error * t, nearest) {
            return MarchHit(max(t + relax * min(above, 0.0), 0.0), true, i + 1, i + 1);
        }
        t += relax * above;
    }
    return MarchHit(t, true, max_steps, max_steps);
}
