// Shapes put together, by their signed distances.
//
// Of distances with slope at most 1 all of these have slope at most 1 again; none is above the true distance outside of the
// result, so that a march by them misses nothing.

#include <math/remap.wgsl>

/// All that is in `a` or in `b`. Exact outside.
fn sdf_union(a: f32, b: f32) -> f32 {
    return min(a, b);
}

/// All that is in `a` and in `b`. Exact inside.
fn sdf_intersection(a: f32, b: f32) -> f32 {
    return max(a, b);
}

/// All that is in `a` and not in `b`.
fn sdf_difference(a: f32, b: f32) -> f32 {
    return max(a, -b);
}

/// As `sdf_union`, the crease filled over `radius` > 0: at most `radius / 4` lower.
fn sdf_smooth_union(a: f32, b: f32, radius: f32) -> f32 {
    return smooth_min(a, b, radius);
}

/// As `sdf_intersection`, the edge rounded over `radius` > 0: at most `radius / 4` higher.
fn sdf_smooth_intersection(a: f32, b: f32, radius: f32) -> f32 {
    return smooth_max(a, b, radius);
}

/// As `sdf_difference`, the edge rounded over `radius` > 0: at most `radius / 4` higher.
fn sdf_smooth_difference(a: f32, b: f32, radius: f32) -> f32 {
    return smooth_max(a, -b, radius);
}

/// A shape on the way from `a` (`part` 0) to `b` (`part` 1).
fn sdf_blend(a: f32, b: f32, part: f32) -> f32 {
    return mix(a, b, clamp(part, 0.0, 1.0));
}
