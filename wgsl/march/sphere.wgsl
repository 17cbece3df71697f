// A ray against a signed distance field (sphere tracing, Hart 1996), and how much of a light it leaves.

#include <march/hit.wgsl>

/// Distance (m) to the surface, negative inside; it may be less than that, or a multiple of it (see `relax`).
#slot sdf: fn(p: vec3f) -> f32

/// First place from `start` (m) to `far` (m) that is nearer to the surface than `nearest` (m) and than half a pixel.
///
/// `direction` is a unit vector. `relax`: 1 / (the steepest slope of `sdf`), 1 for exact distances and bounds of them:
/// then nothing is missed. `pixel_angle` (rad) is a pixel's size; with 0, `nearest` alone counts. A ray that starts
/// inside ends at once. Running out of steps counts as meeting the surface: it happens along edges. `evaluations` are
/// of `sdf`.
fn march(
    origin: vec3f,
    direction: vec3f,
    start: f32,
    far: f32,
    relax: f32,
    nearest: f32,
    pixel_angle: f32,
    max_steps: i32,
) -> MarchHit {
    var t = start;
    for (var i = 0; i < max_steps; i++) {
        if t > far {
            return MarchHit(far, false, i, i);
        }
        let distance = relax * sdf(origin + t * direction);
        if distance < max(nearest, max(0.5 * pixel_angle * t, 2e-7 * t)) {
            return MarchHit(t, true, i + 1, i + 1);
        }
        t += distance;
    }
    return MarchHit(t, t <= far, max_steps, max_steps);
}

/// Whether `origin` sees a light that is `far` (m) away: 1 or 0.
///
/// `start` (m) is where to begin, `nearest` (m) how near to the surface a ray may pass it.
fn shadow_hard(
    origin: vec3f,
    to_light: vec3f,
    start: f32,
    far: f32,
    relax: f32,
    nearest: f32,
    max_steps: i32,
) -> f32 {
    return select(1.0, 0.0, march(origin, to_light, start, far, relax, nearest, 0.0, max_steps).hit);
}

/// Part of a light that is seen from `origin`, 0 (umbra) .. 1.
///
/// The least distance / (distance along the ray), held against the light's size (Quilez 2010): `spread` is its angular
/// radius (rad, > 0). The ray passes on inside, for the half of the penumbra where more than half of the light is
/// covered. `start` > 0 and `far` (m) are where to begin and to give up.
fn shadow_soft(
    origin: vec3f,
    to_light: vec3f,
    spread: f32,
    start: f32,
    far: f32,
    relax: f32,
    max_steps: i32,
) -> f32 {
    var least = 1.0;
    var t = max(start, 1e-3);
    for (var i = 0; i < max_steps; i++) {
        if t > far || least < -1.0 {
            break;
        }
        let distance = relax * sdf(origin + t * to_light);
        least = min(least, distance / (t * spread));
        t += max(abs(distance), 0.5 * t * spread); // no shorter than what the penumbra can show
    }
    return smoothstep(-1.0, 1.0, least);
}
