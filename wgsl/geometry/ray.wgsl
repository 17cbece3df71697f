// Where a ray is inside of a shape: half-space, plane, slab, box, sphere.

/// As far as a ray is followed: no distance below is larger.
const RAY_FAR: f32 = 1e30;

/// The part of a ray that lies inside of a shape, as distances along its unit direction.
///
/// `near` <= `far` where the ray's line meets the shape, `near` > `far` (`RAY_FAR`, -`RAY_FAR`) where it misses. What
/// lies behind the origin is negative: `near` < 0 < `far` is a ray that starts inside, `far` < 0 a shape left behind.
/// Touching counts as meeting. Both are finite for every finite input, and -`RAY_FAR` .. `RAY_FAR`.
struct RaySpan {
    /// Where the line comes in.
    near: f32,
    /// Where it goes out.
    far: f32,
}

/// The span of a ray that misses.
fn ray_missed() -> RaySpan {
    return RaySpan(RAY_FAR, -RAY_FAR);
}

/// Whether the ray, not only its line, meets the shape.
fn ray_meets(span: RaySpan) -> bool {
    return span.far >= max(span.near, 0.0);
}

/// Distance to the first surface ahead: `near`, from inside `far`, and `RAY_FAR` where nothing is ahead.
fn ray_first(span: RaySpan) -> f32 {
    if span.far < max(span.near, 0.0) {
        return RAY_FAR;
    }
    return select(span.far, span.near, span.near >= 0.0);
}

/// The part of two spans that is in both: that of the shapes' intersection, where they are convex.
fn ray_both(a: RaySpan, b: RaySpan) -> RaySpan {
    let near = max(a.near, b.near);
    let far = min(a.far, b.far);
    if near > far {
        return ray_missed();
    }
    return RaySpan(near, far);
}

/// A ray and the plane of all p with dot(p, `normal`) = `offset`: `near` and `far` are both where they cross.
///
/// A ray that runs inside of the plane meets it everywhere; one that runs parallel to it misses.
fn ray_plane(origin: vec3f, direction: vec3f, normal: vec3f, offset: f32) -> RaySpan {
    return ray_slab(dot(origin, normal), dot(direction, normal), offset, offset);
}

/// A ray and the half-space of all p with dot(p, `normal`) <= `offset`: what is below a plane.
fn ray_half_space(origin: vec3f, direction: vec3f, normal: vec3f, offset: f32) -> RaySpan {
    let above = clamp(dot(origin, normal) - offset, -RAY_FAR, RAY_FAR);
    let climb = dot(direction, normal);
    if abs(climb) < 1e-30 {
        if above > 0.0 {
            return ray_missed();
        }
        return RaySpan(-RAY_FAR, RAY_FAR);
    }
    let crossing = clamp(-above / climb, -RAY_FAR, RAY_FAR);
    if climb > 0.0 {
        return RaySpan(-RAY_FAR, crossing);
    }
    return RaySpan(crossing, RAY_FAR);
}

/// A ray and a slab, `low` <= `high`, by the coordinates along the slab's normal: for layers of air `origin.y` and
/// `direction.y`.
///
/// A ray parallel to the slab meets it everywhere or, from outside, nowhere; on a face it is inside.
fn ray_slab(origin: f32, direction: f32, low: f32, high: f32) -> RaySpan {
    let to_low = clamp(low - origin, -RAY_FAR, RAY_FAR);
    let to_high = clamp(high - origin, -RAY_FAR, RAY_FAR);
    if abs(direction) < 1e-30 {
        if to_low > 0.0 || to_high < 0.0 {
            return ray_missed();
        }
        return RaySpan(-RAY_FAR, RAY_FAR);
    }
    let a = clamp(to_low / direction, -RAY_FAR, RAY_FAR);
    let b = clamp(to_high / direction, -RAY_FAR, RAY_FAR);
    return RaySpan(min(a, b), max(a, b));
}

/// A ray and the axis-aligned box from corner `low` to corner `high` (slabs: Kay & Kajiya 1986).
fn ray_box(origin: vec3f, direction: vec3f, low: vec3f, high: vec3f) -> RaySpan {
    let x = ray_slab(origin.x, direction.x, low.x, high.x);
    let y = ray_slab(origin.y, direction.y, low.y, high.y);
    let z = ray_slab(origin.z, direction.z, low.z, high.z);
    return ray_both(ray_both(x, y), z);
}

/// A ray and a sphere.
///
/// By the foot of the perpendicular from the centre, not by b² - 4ac: that would lose a small sphere far away.
fn ray_sphere(origin: vec3f, direction: vec3f, center: vec3f, radius: f32) -> RaySpan {
    let to_center = clamp(center - origin, vec3f(-RAY_FAR), vec3f(RAY_FAR));
    // In units of the largest number at hand: squares then neither overflow nor vanish.
    let size = max(max(max(abs(to_center.x), abs(to_center.y)), abs(to_center.z)), max(radius, 1e-30));
    let c = to_center / size;
    let foot = dot(c, direction);
    let aside = c - foot * direction;
    let r = radius / size;
    let off = length(aside);
    if off > r {
        return ray_missed();
    }
    let half_chord = sqrt((r - off) * (r + off));
    let near = clamp((foot - half_chord) * size, -RAY_FAR, RAY_FAR);
    return RaySpan(near, clamp((foot + half_chord) * size, near, RAY_FAR));
}
