// Puff noise: round heaps with sharp creases between them, at an eighth of the cost of Worley noise.

#include <noise/lattice.wgsl>

/// How far a puff's middle lies from its lattice point, at most, along each axis.
const PUFF_JITTER: f32 = 0.3;
/// A puff's radius. What lies outside of a cell's eight corners is at least this far from the cell.
const PUFF_RADIUS: f32 = 0.7;
/// `puff_noise3` is nowhere steeper: 2 / `PUFF_RADIUS`, at a puff's rim.
const PUFF_NOISE3_SLOPE: f32 = 2.8572;
/// Mean of `puff_noise3`.
const PUFF_NOISE3_MEAN: f32 = 0.462;

/// Heaps in space: 1 in the middle of each puff, 1 - (d / radius)² around it, the largest where several overlap, 0
/// between them. 0 .. 1, continuous.
///
/// Worley noise (1996) inverted, squared and cut off at a radius that only the eight corners of the cell can reach: the
/// search is exact and needs no neighbours. Each puff is displaced by the top 24 bits of its lattice point's hash.
fn puff_noise3(p: vec3f, seed: u32) -> f32 {
    let lattice = floor(p);
    let t = p - lattice;
    let corners = cell_hash3(vec3i(lattice), seed);
    var square = PUFF_RADIUS * PUFF_RADIUS;
    square = min(square, puff_distance2(corners.near.x, t));
    square = min(square, puff_distance2(corners.near.y, t - vec3f(1.0, 0.0, 0.0)));
    square = min(square, puff_distance2(corners.near.z, t - vec3f(0.0, 1.0, 0.0)));
    square = min(square, puff_distance2(corners.near.w, t - vec3f(1.0, 1.0, 0.0)));
    square = min(square, puff_distance2(corners.far.x, t - vec3f(0.0, 0.0, 1.0)));
    square = min(square, puff_distance2(corners.far.y, t - vec3f(1.0, 0.0, 1.0)));
    square = min(square, puff_distance2(corners.far.z, t - vec3f(0.0, 1.0, 1.0)));
    square = min(square, puff_distance2(corners.far.w, t - vec3f(1.0, 1.0, 1.0)));
    return 1.0 - square / (PUFF_RADIUS * PUFF_RADIUS);
}

/// Square of the distance from `d`, seen from a lattice point with this hash, to its puff.
fn puff_distance2(hash: u32, d: vec3f) -> f32 {
    let bytes = vec3u(hash >> 24u, (hash >> 16u) & 255u, (hash >> 8u) & 255u);
    let off = d - PUFF_JITTER * (vec3f(bytes) * (2.0 / 255.0) - 1.0);
    return dot(off, off);
}
