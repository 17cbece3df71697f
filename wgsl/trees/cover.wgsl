// Where trees stand: woods and clearings, between the waterline and the tree line, on ground that is not too steep.

#include <fractal/fbm.wgsl> as groves with noise2 = perlin_noise2_grad
#include <noise/perlin.wgsl>

/// Which woods of their kind: another seed, other trees.
#param trees.seed: u32 = 1
/// How much of the ground between the waterline and the tree line is wooded.
#param trees.share: f32 = 0.6, range 0 .. 1
/// How wide woods and clearings are.
#param trees.patch: f32 = 500.0, range 10 .. 10000, log, unit m
/// Height below which no tree stands: the waterline.
#param trees.lowest: f32 = 0.0, range -1000 .. 9000, unit m
/// Height above which no tree stands.
#param trees.highest: f32 = 900.0, range -1000 .. 9000, unit m
/// How far up and down from `trees.highest` the woods thin out; at the waterline, a tenth of it.
#param trees.raggedness: f32 = 80.0, range 0 .. 2000, unit m
/// Steepest slope on which trees hold.
#param trees.steepest: f32 = 38.0, range 1 .. 89, unit deg
/// How much of the woods is spruce.
#param trees.spruces: f32 = 0.5, range 0 .. 1
/// Albedo of a closed canopy of spruces seen from afar, the dark between the crowns included.
#param trees.spruce_canopy: vec3f = (0.012, 0.020, 0.010), color
/// Albedo of a closed canopy of broadleaved trees seen from afar, the dark between the crowns included.
#param trees.leaf_canopy: vec3f = (0.032, 0.050, 0.014), color
/// How far autumn has come: 0 summer, 1 all leaves turned.
#param trees.autumn: f32 = 0.0, range 0 .. 1

/// What to add to a noise so that about `share` of it is above 0: nothing of it for 0, all of it for 1. `contrast`: how
/// much a change in the middle of the range does.
fn share_shift(share: f32, contrast: f32) -> f32 {
    return contrast * (share - 0.5) + 15.0 * (max(share - 0.9, 0.0) - max(0.1 - share, 0.0));
}

/// A number that says how deep in the woods `p` (m) lies: above 0 inside, below 0 in a clearing; about -1 .. 1.
///
/// Four octaves of noise.
fn woods_depth(p: vec2f) -> f32 {
    let wander = groves_fbm2(p / trees.patch, trees.seed + 17u, 4.0, 0.5, 2.1).x;
    return wander + share_shift(trees.share, 1.3);
}

/// Part of the ground under trees, 0 .. 1, as far as the woods decide: nothing in clearings, thinner at their edges.
fn woods_density(depth: f32) -> f32 {
    return smoothstep(-0.04, 0.10, depth);
}

/// What height and slope leave of the woods, 0 .. 1: 0 at and below `trees.lowest`, above `trees.highest` +
/// `trees.raggedness`, and where it is steeper than `trees.steepest`.
fn woods_limits(height: f32, normal_y: f32, depth: f32) -> f32 {
    let ragged = max(trees.raggedness, 0.1);
    let over = height - trees.highest - 0.8 * ragged * clamp(depth, -1.0, 1.0);
    let below_line = 1.0 - smoothstep(-0.8 * ragged, 0.2 * ragged, over);
    let above_water = smoothstep(trees.lowest, trees.lowest + 0.1 * ragged, height);
    let level = smoothstep(cos(trees.steepest), cos(0.7 * trees.steepest), normal_y);
    return below_line * above_water * level;
}

/// Part of the ground under trees, 0 .. 1, at `position` (m) with unit `normal`: the chance that a cell of the grid of
/// trees has one. 0 wherever a limit is overstepped. Four octaves of noise.
fn trees_cover(position: vec3f, normal: vec3f) -> f32 {
    let depth = woods_depth(position.xz);
    return woods_density(depth) * woods_limits(position.y, normal.y, depth);
}

/// Chance that a tree at `p` (m) is a spruce, 0 .. 1. Three octaves of noise.
fn trees_spruces_at(p: vec2f) -> f32 {
    let wander = groves_fbm2(p / (0.45 * trees.patch) + vec2f(7.7, 3.1), trees.seed + 29u, 3.0, 0.6, 2.1).x;
    return smoothstep(-0.32, 0.32, wander + share_shift(trees.spruces, 1.5));
}

/// Colour of a leaf in autumn; `when`: 0 .. 1, how early it turned.
fn autumn_leaf(when: f32) -> vec3f {
    let gold = mix(vec3f(0.16, 0.13, 0.015), vec3f(0.28, 0.15, 0.012), smoothstep(0.0, 0.45, when));
    return mix(gold, vec3f(0.20, 0.055, 0.010), smoothstep(0.45, 1.0, when));
}

/// Albedo of the woods at `p` (m) as they look from so far that no tree is seen. Linear sRGB, 0 .. 1. Three octaves of
/// noise.
fn trees_canopy_albedo(p: vec2f) -> vec3f {
    let turned = 0.28 * autumn_leaf(0.4);
    let broadleaf = mix(trees.leaf_canopy, turned, 0.8 * trees.autumn);
    return mix(broadleaf, trees.spruce_canopy, trees_spruces_at(p));
}
