// A globe whose topmost point is the origin: heights and crossings without loss of digits near that point.
//
// The centre is at (0, -radius, 0), so that places near the origin are small numbers, as over flat land, and the same
// coordinates serve from the ground up to other planets.

#include <geometry/ray.wgsl>

/// Unit vector away from the globe's centre at `p` (m); (0, 1, 0) in the centre.
fn globe_up(p: vec3f, radius: f32) -> vec3f {
    let out = vec3f(p.x, p.y + radius, p.z) / radius;
    let length2 = dot(out, out);
    if length2 < 1e-20 {
        return vec3f(0.0, 1.0, 0.0);
    }
    return out * inverseSqrt(length2);
}

/// Height of `p` (m) above the globe's surface: |p - centre| - radius, without the cancellation.
///
/// Near the origin its error is that of `p`, not of numbers as large as the radius.
fn globe_height(p: vec3f, radius: f32) -> f32 {
    let q = p / radius;
    let out = length(vec3f(q.x, q.y + 1.0, q.z));
    return radius * (2.0 * q.y + dot(q, q)) / (out + 1.0);
}

/// Unit vectors to the east, up and to the south at a place whose unit `up` is given, as the columns of a matrix: what
/// x, y and z are at the origin. Around the point opposite to the origin the compass turns.
fn globe_frame(up: vec3f) -> mat3x3f {
    // The shortest rotation from (0, 1, 0) to `up` (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
    let fold = select(-1.0, 1.0, up.y >= 0.0);
    let a = -1.0 / (fold + up.y);
    let b = up.x * up.z * a;
    return mat3x3f(
        vec3f(1.0 + fold * up.x * up.x * a, -fold * up.x, fold * b),
        up,
        vec3f(b, -up.z, fold + up.z * up.z * a),
    );
}

/// The part of a ray inside of the sphere `height` (m) above a globe, as `ray_sphere` has it; as exact as the unit
/// `direction` also where `origin` (m) is close to the sphere, which `ray_sphere` is not.
fn globe_span(origin: vec3f, direction: vec3f, radius: f32, height: f32) -> RaySpan {
    // In units of the radius: t² + 2 b t + c = 0.
    let q = origin / radius;
    let above = globe_height(origin, radius) / radius - height / radius;
    let outer = 1.0 + height / radius;
    let b = direction.y + dot(q, direction);
    let c = above * (2.0 * outer + above);
    // The square of half the chord: near the sphere from b and c, which are small; from afar by the foot of the perpendicular
    // from the centre, without the difference of large squares.
    let out = vec3f(q.x, q.y + 1.0, q.z);
    let foot = length(out - b * direction);
    let inside = select((outer - foot) * (outer + foot), b * b - c, max(b * b, abs(c)) < 1.0);
    if inside < 0.0 {
        return ray_missed();
    }
    let half_chord = sqrt(max(inside, 1e-30));
    // The root of larger size first; the other from their product.
    let large = -b - select(-half_chord, half_chord, b >= 0.0);
    let small = c / select(min(large, -1e-15), max(large, 1e-15), large >= 0.0);
    return RaySpan(radius * min(large, small), radius * max(large, small));
}
