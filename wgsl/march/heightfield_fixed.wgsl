// A ray against a heightfield in steps of one length.

#include <march/hit.wgsl>

/// Height of the ground (m) at a place of the map (m); details much smaller than `footprint` (m) may be left out.
#slot height: fn(p: vec2f, footprint: f32) -> f32

/// First crossing of the ground along a ray, taken as a straight line between the two steps around it.
///
/// `direction` is a unit vector; looks from the origin to `far` (m) in `count` >= 1 steps. `ceiling` (m): a height that
/// the ground nowhere exceeds; above it nothing is looked for. Misses what lies between two steps. A ray that starts
/// below the ground ends at once.
fn march(origin: vec3f, direction: vec3f, ceiling: f32, far: f32, count: i32, pixel_angle: f32) -> MarchHit {
    let length = far / f32(max(count, 1));
    var above_before = 0.0;
    for (var i = 0; i <= count; i++) {
        let t = f32(i) * length;
        let p = origin + t * direction;
        if p.y > ceiling && direction.y >= 0.0 {
            return MarchHit(far, false, i, i);
        }
        let above = p.y - height(p.xz, t * pixel_angle);
        if above <= 0.0 {
            let back = select(0.0, above / min(above - above_before, -1e-20), i > 0);
            return MarchHit(t - clamp(back, 0.0, 1.0) * length, true, i + 1, i + 1);
        }
        above_before = above;
    }
    return MarchHit(far, false, count + 1, count + 1);
}
