// How much of the land a map or a slice shows, and which heights.

#include <camera/camera.wgsl>
#include <frame.wgsl>
#include <terrain/height.wgsl>

/// How much land the picture shows from its left to its right edge; 0 is three times `terrain.scale`.
#param inspect.extent: f32 = 0.0, range 0 .. 10000000, unit m
/// Lowest height that is told from those below it.
#param inspect.low: f32 = 0.0, range -12000 .. 100000, unit m
/// Highest height that is told from those above it; where it is not above `inspect.low`, the land's own ceiling.
#param inspect.high: f32 = 0.0, range -12000 .. 100000, unit m

/// Width of a pixel on the land (m).
fn extent_pixel() -> f32 {
    let whole = select(inspect.extent, 3.0 * terrain.scale, inspect.extent <= 0.0);
    return whole / frame.resolution.x;
}

/// The lowest and the highest height (m) that are told apart.
fn extent_heights() -> vec2f {
    let ceiling = max(terrain_ceiling(), inspect.low + 1.0);
    return vec2f(inspect.low, select(inspect.high, ceiling, inspect.high <= inspect.low));
}
