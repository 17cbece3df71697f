// Normals of a surface that is given by its signed distance.

#include <math/rotation.wgsl>

/// Signed distance to the surface (m), or all else that grows outward.
#slot sdf: fn(p: vec3f) -> f32

/// Unit normal at `p`, from four samples at the corners of a tetrahedron `reach` > 0 away; up where the distance has no
/// slope.
///
/// Error of first order in `reach` where the surface bends, none on a plane. A loop, since compilers copy the distance
/// into every place that it is called from.
fn normal_tetrahedron(p: vec3f, reach: f32) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0; i < 4; i++) {
        // (1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1)
        let corner = vec3f(
            select(-1.0, 1.0, i == 0 || i == 3),
            select(-1.0, 1.0, i == 0 || i == 2),
            select(-1.0, 1.0, i == 0 || i == 1),
        );
        sum += corner * (sdf(p + 0.57735027 * reach * corner) / reach);
    }
    return normalize_or(sum, vec3f(0.0, 1.0, 0.0));
}

/// Unit normal at `p`, from six samples `reach` > 0 away along the axes; up where the distance has no slope. Error of
/// second order in `reach`.
fn normal_central(p: vec3f, reach: f32) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0; i < 6; i++) {
        let side = select(1.0, -1.0, (i & 1) == 1);
        var offset = vec3f(0.0);
        offset[i / 2] = side;
        sum += offset * (sdf(p + reach * offset) / reach);
    }
    return normalize_or(sum, vec3f(0.0, 1.0, 0.0));
}
