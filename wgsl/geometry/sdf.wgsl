// Signed distances to simple shapes around the origin: negative inside.
//
// Finite for all coordinates and sizes up to 1e18. All but the ellipsoid are exact, hence of slope 1.

/// Distance to a sphere of `radius`.
fn sdf_sphere(p: vec3f, radius: f32) -> f32 {
    return length(p) - radius;
}

/// A bound of the distance to an ellipsoid with half-axes `radii` > 0: never above the true signed distance, and of its
/// sign.
///
/// k0 (k0 - 1) / k1, the first-order distance to the level set k0 = 1 (Quilez). It is a bound since k0 = |p / radii| is
/// convex: its tangent lies below it. Near the surface it is exact to second order; at the centre -min(radii). Its slope
/// outside is 1 at most for axes up to 1 : 1.5 : 1, but 2.5 for 1 : 2 : 0.5.
fn sdf_ellipsoid(p: vec3f, radii: vec3f) -> f32 {
    let q = p / radii;
    let k0 = length(q);
    let k1 = length(q / radii);
    if k0 < 1e-6 {
        return -min(min(radii.x, radii.y), radii.z);
    }
    return k0 * (k0 - 1.0) / k1;
}

/// Distance to a box with half its width, height and depth in `half_size`.
fn sdf_box(p: vec3f, half_size: vec3f) -> f32 {
    let q = abs(p) - half_size;
    return length(max(q, vec3f(0.0))) + min(max(max(q.x, q.y), q.z), 0.0);
}

/// Distance to an upright cylinder of `radius`, from -`half_height` to `half_height`.
fn sdf_cylinder(p: vec3f, radius: f32, half_height: f32) -> f32 {
    let q = vec2f(length(p.xz) - radius, abs(p.y) - half_height);
    return length(max(q, vec2f(0.0))) + min(max(q.x, q.y), 0.0);
}

/// Distance to a lying torus: a tube of `minor` radius along a circle of `major` radius.
fn sdf_torus(p: vec3f, major: f32, minor: f32) -> f32 {
    return length(vec2f(length(p.xz) - major, p.y)) - minor;
}

/// Distance to a capsule: all that is within `radius` of the segment from `a` to `b`, which may be one point.
fn sdf_capsule(p: vec3f, a: vec3f, b: vec3f, radius: f32) -> f32 {
    let from_a = p - a;
    let along = b - a;
    let part = clamp(dot(from_a, along) / max(dot(along, along), 1e-30), 0.0, 1.0);
    return length(from_a - part * along) - radius;
}
