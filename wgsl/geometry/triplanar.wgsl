// Three planes around a sphere: how a flat map becomes a globe's.
//
// Each place of the unit sphere looks at the planes across x, y and z through the weights |direction|^sharpness, normalised:
// the map is read once on each plane, at the two other coordinates.

/// How much each of the three planes counts, and how that changes.
struct Triplanar {
    /// Weights of the planes across x, y and z: 0 .. 1, in all 1.
    weights: vec3f,
    /// Column i: gradient of weight i by position, on the unit sphere.
    gradients: mat3x3f,
}

// Planes that count less than the first of these do not count at all, and need not be read; the smooth step to the second
// keeps the weights' slope continuous.
const TRIPLANAR_NONE: f32 = 0.004;
const TRIPLANAR_FULL: f32 = 0.040;

/// The weights at the unit `direction`. `sharpness` > 1: larger is a narrower blend between planes.
fn triplanar_weights(direction: vec3f, sharpness: f32) -> Triplanar {
    let size = max(abs(direction), vec3f(1e-6));
    let raised = exp2(sharpness * log2(size));
    let sum = raised.x + raised.y + raised.z;
    let share = raised / sum;
    // d ln(raised_i) / d direction_i, times the share: the part that is finite where a coordinate is 0.
    let steepness = sharpness * sign(direction) * share / size;

    let t = clamp((share - TRIPLANAR_NONE) / (TRIPLANAR_FULL - TRIPLANAR_NONE), vec3f(0.0), vec3f(1.0));
    let kept = t * t * (3.0 - 2.0 * t);
    let fading = share * 6.0 * t * (1.0 - t) / (TRIPLANAR_FULL - TRIPLANAR_NONE);
    let value = share * kept;
    let slope = kept + fading;
    let total = value.x + value.y + value.z;
    let weights = value / total;

    let x = slope.x * (vec3f(steepness.x, 0.0, 0.0) - share.x * steepness);
    let y = slope.y * (vec3f(0.0, steepness.y, 0.0) - share.y * steepness);
    let z = slope.z * (vec3f(0.0, 0.0, steepness.z) - share.z * steepness);
    let all = x + y + z;
    return Triplanar(
        weights,
        mat3x3f((x - weights.x * all) / total, (y - weights.y * all) / total, (z - weights.z * all) / total),
    );
}
