//! Rays, distances and normals in f64, from what they mean.

/// A point or a direction.
pub type Vec3 = [f64; 3];

/// `f32`s widened.
#[must_use]
pub fn wide(p: [f32; 3]) -> Vec3 {
    p.map(f64::from)
}

/// Scalar product.
#[must_use]
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a + t b`.
#[must_use]
pub fn along(a: Vec3, t: f64, b: Vec3) -> Vec3 {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

/// Length of `a - b`.
#[must_use]
pub fn distance(a: Vec3, b: Vec3) -> f64 {
    length(along(a, -1.0, b))
}

/// Length.
#[must_use]
pub fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// `a` of length 1.
#[must_use]
pub fn unit(a: Vec3) -> Vec3 {
    let size = length(a);
    a.map(|x| x / size)
}

/// Where a line is inside of a sphere: the roots of |o + t d - c|² = r².
#[must_use]
pub fn ray_sphere(origin: Vec3, direction: Vec3, center: Vec3, radius: f64) -> Option<(f64, f64)> {
    let oc = along(origin, -1.0, center);
    let a = dot(direction, direction);
    let b = dot(oc, direction);
    let c = dot(oc, oc) - radius * radius;
    let disc = b * b - a * c;
    (disc >= 0.0).then(|| ((-b - disc.sqrt()) / a, (-b + disc.sqrt()) / a))
}

/// Where a line is inside of an axis-aligned box: the parameters that lie between all three pairs of faces.
#[must_use]
pub fn ray_box(origin: Vec3, direction: Vec3, low: Vec3, high: Vec3) -> Option<(f64, f64)> {
    let mut span = (f64::NEG_INFINITY, f64::INFINITY);
    for i in 0..3 {
        if direction[i] == 0.0 {
            if origin[i] < low[i] || origin[i] > high[i] {
                return None;
            }
            continue;
        }
        let (a, b) = ((low[i] - origin[i]) / direction[i], (high[i] - origin[i]) / direction[i]);
        span = (span.0.max(a.min(b)), span.1.min(a.max(b)));
    }
    (span.0 <= span.1).then_some(span)
}

/// Signed distance to a box: to the nearest of its points, or of its faces from inside.
#[must_use]
pub fn to_box(p: Vec3, half: Vec3) -> f64 {
    let nearest: Vec3 = std::array::from_fn(|i| p[i].clamp(-half[i], half[i]));
    let outside = distance(p, nearest);
    if outside > 0.0 {
        return outside;
    }
    -(0..3).map(|i| half[i] - p[i].abs()).fold(f64::INFINITY, f64::min)
}

/// Signed distance to an upright cylinder.
#[must_use]
pub fn to_cylinder(p: Vec3, radius: f64, half_height: f64) -> f64 {
    let from_axis = p[0].hypot(p[2]);
    let nearest = (from_axis.min(radius), p[1].clamp(-half_height, half_height));
    let outside = (from_axis - nearest.0).hypot(p[1] - nearest.1);
    if outside > 0.0 {
        return outside;
    }
    -(radius - from_axis).min(half_height - p[1].abs())
}

/// Signed distance to a lying torus: from the nearest point of the circle inside of the tube.
#[must_use]
pub fn to_torus(p: Vec3, major: f64, minor: f64) -> f64 {
    let angle = p[2].atan2(p[0]);
    distance(p, [major * angle.cos(), 0.0, major * angle.sin()]) - minor
}

/// Signed distance to a capsule: the nearest point of its segment is looked for (golden section), not solved for.
#[must_use]
pub fn to_capsule(p: Vec3, a: Vec3, b: Vec3, radius: f64) -> f64 {
    let step = along(b, -1.0, a);
    let at = |t: f64| distance(p, along(a, t, step));
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..90 {
        let (l, h) = (high - 0.618_033_988_75 * (high - low), low + 0.618_033_988_75 * (high - low));
        if at(l) < at(h) { high = h } else { low = l }
    }
    at(0.0).min(at(1.0)).min(at(f64::midpoint(low, high))) - radius
}

/// True signed distance to an ellipsoid with different half-axes, by the nearest point: q = r² p / (r² + t) with the t that
/// puts q on the surface, by bisection (Eberly).
#[must_use]
pub fn to_ellipsoid(p: Vec3, radii: Vec3) -> f64 {
    let p = p.map(f64::abs);
    let level =
        |t: f64| -> f64 { (0..3).map(|i| (radii[i] * p[i] / (radii[i] * radii[i] + t)).powi(2)).sum() };
    let least = radii.iter().copied().fold(f64::INFINITY, f64::min);
    let mut low = -least * least * (1.0 - 1e-15);
    let mut high = length(p) * radii.iter().copied().fold(0.0, f64::max) + 1.0;
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if level(middle) > 1.0 { low = middle } else { high = middle }
    }
    let t = f64::midpoint(low, high);
    let mut nearest: Vec3 = std::array::from_fn(|i| radii[i] * radii[i] * p[i] / (radii[i] * radii[i] + t));
    // At the bottom of the bracket the nearest point lies off the smallest axis' plane: what is missing goes there.
    let missing = 1.0 - (0..3).map(|i| (nearest[i] / radii[i]).powi(2)).sum::<f64>();
    if missing > 0.0
        && let Some(i) = (0..3).find(|&i| radii[i] == least)
    {
        nearest[i] = radii[i] * ((nearest[i] / radii[i]).powi(2) + missing).sqrt();
    }
    let inside = (0..3).map(|i| (p[i] / radii[i]).powi(2)).sum::<f64>() < 1.0;
    distance(p, nearest) * if inside { -1.0 } else { 1.0 }
}

/// Which face of a cube texture is sampled in `direction` of the texture's own, left-handed axes, and where on it: 0 .. 1
/// from the left and from the top. The table of WebGPU's, Vulkan's and Direct3D's specifications: the major axis chooses
/// the face, the two others over it are the place.
#[must_use]
pub fn cube_texel(direction: Vec3) -> (usize, [f64; 2]) {
    let [x, y, z] = direction;
    let [ax, ay, az] = direction.map(f64::abs);
    let (face, s, t, major) = if az >= ax && az >= ay {
        if z < 0.0 { (5, -x, -y, az) } else { (4, x, -y, az) }
    } else if ay >= ax {
        if y < 0.0 { (3, x, -z, ay) } else { (2, x, z, ay) }
    } else if x < 0.0 {
        (1, z, -y, ax)
    } else {
        (0, -z, -y, ax)
    };
    (face, [0.5 * (s / major + 1.0), 0.5 * (t / major + 1.0)])
}
