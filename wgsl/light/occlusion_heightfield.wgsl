// How much of the sky is seen from a point of a heightfield.

/// Height of the ground (m) at a place of the map (m); details much smaller than `footprint` (m) may be left out.
#slot height: fn(p: vec2f, footprint: f32) -> f32

/// Part of an even sky's light that reaches level ground at `position` (m), 0 .. 1.
///
/// In each of `directions` >= 1 directions the horizon is the highest angle to `samples` >= 1 samples of the ground,
/// from `start` (m) to `reach` (m), each farther than the last by the same factor; a sky hidden up to the elevation h
/// leaves cos² h of the light in that direction (Max 1988). `turn` (rad) turns all directions. Exact for a crater of
/// even slopes; for a valley between two slopes within 2e-3 with 8 directions, up to a slope of 1. The detail looked
/// at is half as wide as the gap between samples.
fn sky_openness(position: vec3f, start: f32, reach: f32, directions: i32, samples: i32, turn: f32) -> f32 {
    let growth = pow(max(reach / start, 1.0), 1.0 / f32(max(samples - 1, 1)));
    var seen = 0.0;
    for (var i = 0; i < directions; i++) {
        let angle = turn + 6.2831853 * f32(i) / f32(directions);
        let toward = vec2f(cos(angle), sin(angle));
        var steepest = 0.0;
        var away = start;
        for (var j = 0; j < samples; j++) {
            let rise = height(position.xz + away * toward, 0.5 * (growth - 1.0) * away) - position.y;
            steepest = max(steepest, rise / away);
            away *= growth;
        }
        seen += 1.0 / (1.0 + steepest * steepest);
    }
    return seen / f32(directions);
}
