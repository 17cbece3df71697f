// How much of the surroundings' light reaches a point among shapes that are given by a signed distance.

/// Signed distance (m), of slope at most 1.
#slot sdf: fn(p: vec3f) -> f32

/// Part of the light from all around that reaches `p`, 0 .. 1, by steps along the unit `normal` out to `reach` (m).
///
/// Where nothing else is near, the distance grows as fast as the step; what it lacks hides light (Evans 2006). Each of
/// the `samples` >= 1 steps is 1.5 times as long as the one before and counts 2/3 of it. Exactly 1 on a lone plane.
fn ambient_occlusion(p: vec3f, normal: vec3f, reach: f32, samples: i32) -> f32 {
    var hidden = 0.0;
    var weights = 0.0;
    var weight = 1.0;
    var along = reach / pow(1.5, f32(samples - 1));
    for (var i = 0; i < samples; i++) {
        let open = clamp(sdf(p + along * normal) / along, 0.0, 1.0);
        hidden += weight * (1.0 - open);
        weights += weight;
        weight *= 2.0 / 3.0;
        along *= 1.5;
    }
    return clamp(1.0 - hidden / weights, 0.0, 1.0);
}
