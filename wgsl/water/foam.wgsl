// Foam where water breaks on the shore.

#include <frame.wgsl>
#include <noise/perlin.wgsl>

/// How much foam there is at the shore: 0 none, as on a still lake.
#param water.foam: f32 = 0.3, range 0 .. 1
/// Depth of the water in which it lies.
#param water.foam_depth: f32 = 0.35, range 0.01 .. 10, unit m

const FOAM_ALBEDO: f32 = 0.75;

/// Part of the surface that is foam, 0 .. 1, at `p` (m) over ground `depth` (m) down; 0 at depth 0 and from
/// `water.foam_depth` down. Three noises.
fn shore_foam(p: vec2f, depth: f32, footprint: f32) -> f32 {
    if water.foam <= 0.0 || depth <= 0.0 || depth >= water.foam_depth {
        return 0.0;
    }
    // Bands that come in with the swash, torn by noise.
    let part = depth / water.foam_depth;
    let ragged = perlin_noise2(p / 1.9 + vec2f(0.0, 0.11 * frame.time), 31u);
    let lace = perlin_noise2(p / 0.33 + 0.07 * frame.time, 33u) * (1.0 - smoothstep(0.1, 0.35, footprint));
    let swash = 0.5 + 0.5 * sin(6.2831853 * (1.5 * part + 0.16 * frame.time) + 2.5 * ragged);
    let cover = smoothstep(0.45, 1.0, swash + 0.45 * lace + 0.25 * ragged);
    return water.foam * cover * smoothstep(0.0, 0.12, part) * (1.0 - smoothstep(0.5, 1.0, part));
}
