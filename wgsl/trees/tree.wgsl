// One tree: which one stands in a cell of the grid, and its shape. Broadleaved crowns are ellipsoids, spruces are cones
// of drooping whorls; leaves eat into both.

#include <frame.wgsl>
#include <noise/pcg.wgsl>
#include <noise/value.wgsl>
#include <trees/cover.wgsl>

/// Width of a cell of the grid; each cell has one tree at most.
#param trees.spacing: f32 = 6.5, range 1 .. 50, unit m
/// Height of the tallest trees.
#param trees.tallest: f32 = 24.0, range 1 .. 90, unit m
/// How far a tree's top sways in the wind.
#param trees.sway: f32 = 0.0, range 0 .. 1, unit m
/// Size of a tuft of leaves.
#param trees.tuft: f32 = 0.55, range 0.05 .. 3, unit m

const TREE_JITTER: f32 = 0.36; // how far a trunk stands off its cell's middle, in cells
const TREE_REACH: f32 = 0.60; // widest crown, in cells
const TREE_OVERHANG: f32 = TREE_REACH + TREE_JITTER - 0.5; // farthest that a tree reaches out of its cell, in cells
const SPRUCE_TOP_YEAR: f32 = 0.020; // from the topmost whorl to the top, in heights of the tree
const SPRUCE_GROWTH: f32 = 0.062; // by how much lower whorls are farther apart, in heights of the tree
const SPRUCE_SECTOR: f32 = 0.897598; // angle between the branches of a whorl: a seventh of a turn
const SPRUCE_DROOP: f32 = 0.45; // how far a branch sinks on its way outward, as a part of that way
const SPRUCE_STEEPNESS: f32 = 1.75; // of `spruce_branches`: edges of the fans and the droop together
const SPRUCE_LEADER: f32 = 0.35; // upper part of a spruce that tapers to a point
const TREE_ROOT: f32 = 3.0; // how deep the trunk goes on under ground (m): the ground is coarser at the trunk

/// A tree. `tree_in_cell` knows all but the ground it stands on.
struct Tree {
    /// The same number for the same tree, wherever it is seen from.
    id: u32,
    /// Foot of the trunk (m).
    foot: vec3f,
    /// From the foot to the top (m).
    height: f32,
    /// Of the crown, leaves included (m); at most `TREE_REACH` cells.
    radius: f32,
    /// Where the crown begins (m above the foot).
    crown: f32,
    /// Of the trunk (m).
    trunk: f32,
    /// Spruce, or else broadleaved.
    spruce: bool,
    /// It stands if the woods are at least so dense, 0 .. 1.
    chance: f32,
}

/// The tree of a cell: where it would stand, how old and how tall; its foot is left at height 0 and its species open.
/// One hash and what follows from it.
fn tree_in_cell(cell: vec2i) -> Tree {
    let id = pcg_cell2(cell, trees.seed);
    let place = unit_float2(pcg2d(vec2u(id, 1u))) - vec2f(0.5);
    let dice = unit_float2(pcg2d(vec2u(id, 2u)));
    var tree: Tree;
    tree.id = id;
    let at = (vec2f(cell) + vec2f(0.5) + 2.0 * TREE_JITTER * place) * trees.spacing;
    tree.foot = vec3f(at.x, 0.0, at.y);
    let age = 1.0 - 0.75 * dice.x * dice.x; // most are grown up
    tree.height = trees.tallest * age;
    tree.radius = TREE_REACH * trees.spacing;
    tree.chance = dice.y;
    return tree;
}

/// Gives the tree its species, and the girth and height that go with it. `depth`: `woods_depth` where it stands.
/// Three octaves of noise.
fn tree_grow(sapling: Tree, depth: f32) -> Tree {
    var tree = sapling;
    let dice = unit_float2(pcg2d(vec2u(tree.id, 3u)));
    tree.spruce = dice.x < trees_spruces_at(tree.foot.xz);
    let edge = 0.55 + 0.45 * smoothstep(-0.02, 0.16, depth); // the woods begin with young trees
    let widest = TREE_REACH * trees.spacing; // as far as the tree may reach
    if tree.spruce {
        tree.height *= edge;
        tree.radius = min(widest, tree.height * (0.13 + 0.05 * dice.y) + 0.4);
        tree.crown = 0.06 * tree.height;
    } else {
        tree.height *= edge * (0.68 + 0.14 * dice.y);
        tree.radius = min(widest, tree.height * (0.29 + 0.09 * dice.y) + 0.3);
        tree.crown = tree.height * (0.16 + 0.12 * dice.y);
    }
    tree.trunk = 0.016 * tree.height + 0.03;
    return tree;
}

/// Where a tree's axis stands at `height` (m) above its foot: bent by the wind. (east, south) in m from the foot.
fn tree_sway(tree: Tree, height: f32) -> vec2f {
    let phase = 6.2831853 * unit_float(tree.id) + 0.08 * (tree.foot.x + tree.foot.z);
    let bend = clamp(height / tree.height, 0.0, 1.2);
    let wind = vec2f(sin(1.3 * frame.time + phase), cos(1.7 * frame.time + 1.3 * phase));
    return 0.7 * trees.sway * bend * bend * wind;
}

/// The crown without leaves: (value, gradient) at `q` (m from the foot). Negative inside; its gradient is at most 1 for
/// broadleaved trees and `SPRUCE_STEEPNESS` for spruces.
///
/// Broadleaved: (|s| - 1) times the shortest radius, s being `q` in radii of an ellipsoid with a flatter lower half.
/// (The usual bound |s| (|s| - 1) / |s / r| is nearer, but its gradient exceeds 1.) Spruce: branches in a cone.
fn crown_hull(tree: Tree, q: vec3f, footprint: f32) -> vec4f {
    if tree.spruce {
        return spruce_branches(tree, q, footprint);
    }
    let half = (tree.height - tree.crown) / 1.65;
    let middle = tree.height - half;
    let radii = vec3f(tree.radius, select(0.65 * half, half, q.y > middle), tree.radius);
    let s = (q - vec3f(0.0, middle, 0.0)) / radii;
    let k = max(length(s), 1e-4);
    let shortest = min(tree.radius, 0.65 * half);
    return vec4f(shortest * (k - 1.0), shortest / k * s / radii);
}

/// The cone that a spruce fills: (value, gradient); gradient at most 1.
fn spruce_cone(tree: Tree, q: vec3f) -> vec4f {
    let slope = tree.radius / (tree.height - tree.crown);
    let scale = inverseSqrt(1.0 + slope * slope);
    let axis = max(length(q.xz), 1e-4);
    let side = scale * (axis - slope * (tree.height - q.y));
    let under = 0.9438 * (tree.crown + 0.35 * axis - q.y); // 1 / sqrt(1 + 0.35²)
    if under > side {
        return 0.9438 * vec4f(under / 0.9438, 0.35 * q.x / axis, -1.0, 0.35 * q.z / axis);
    }
    return vec4f(side, scale * q.x / axis, scale * slope, scale * q.z / axis);
}

/// A spruce: whorls of branches, one for each year, within a cone; (value, gradient).
///
/// Each branch is a fan that droops. A whorl is turned by the golden angle against the one below.
fn spruce_branches(tree: Tree, q: vec3f, footprint: f32) -> vec4f {
    let cone = spruce_cone(tree, q);
    let axis = max(length(q.xz), 1e-4);
    let outward = q.xz / axis;
    let angle = atan2(q.z, select(q.x, 1e-4, axis <= 1e-4));
    let rise = inverseSqrt(1.0 + SPRUCE_DROOP * SPRUCE_DROOP);
    // Years are shorter toward the top: year = height · (top + growth · part below the top), and their sum is a log.
    let below_top = max(1.0 - (q.y + SPRUCE_DROOP * axis) / tree.height, 0.0);
    let shrunk = SPRUCE_TOP_YEAR + SPRUCE_GROWTH * below_top;
    let year = shrunk * tree.height;
    let level = unit_float(tree.id) - log(shrunk) / SPRUCE_GROWTH;
    let seen = 1.0 - smoothstep(0.15, 0.6, footprint / year);
    let eaten = 0.5 * dot(crown_amplitudes(tree), vec3f(1.0)); // what the leaves will take
    let held = clamp((tree.height - q.y) / (SPRUCE_LEADER * tree.height), 0.0, 1.0);
    // A core that nothing is seen through.
    var found = vec4f(axis - 0.25 * (axis - cone.x) - held * eaten, outward.x, 0.1, outward.y);
    for (var i = 0; i < 2; i++) {
        let whorl = floor(level) + f32(i);
        let turn = angle + 2.39996 * whorl;
        let sector = turn - SPRUCE_SECTOR * round(turn / SPRUCE_SECTOR);
        let aside = axis * abs(sin(sector)) - 0.30 * axis - 0.10; // beyond the fan's edge
        let apart = max(aside, 0.0);
        let over = rise * (level - whorl) * year;
        let away = max(sqrt(apart * apart + over * over), 1e-4);
        let value = away - 0.13 * year - held * eaten;
        if value < found.x {
            let across = select(-1.0, 1.0, sector > 0.0) * vec2f(-outward.y, outward.x) - 0.30 * outward;
            let flat_part = apart / away * across + over / away * rise * SPRUCE_DROOP * outward;
            found = vec4f(value, flat_part.x, over / away * rise, flat_part.y);
        }
    }
    if seen < 1.0 {
        found = mix(vec4f(cone.x + 0.3 * year, cone.yzw), found, seen);
    }
    if cone.x > found.x {
        return cone;
    }
    return found;
}

/// How much leaves eat into the crown: (depth in m, gradient) at `q` (m from the foot), for a pixel `footprint` (m)
/// wide. Never negative.
///
/// Three sizes: boughs, tufts, leaves; those too small for the pixel become their mean. One noise for each.
fn crown_leaves(tree: Tree, q: vec3f, footprint: f32) -> vec4f {
    let amplitudes = crown_amplitudes(tree);
    let scales = crown_scales(tree);
    let origin = 40.0 * unit_float3(pcg3d(vec3u(tree.id, 5u, 7u)));
    var sum = vec4f(0.0);
    var presence = 1.0;
    for (var i = 0; i < 3; i++) {
        if i > 0 {
            presence = 1.0 - smoothstep(0.3, 1.2, footprint / scales[i]);
        }
        if presence <= 0.0 {
            sum.x += 0.5 * amplitudes[i];
            continue;
        }
        let wide = 1.0 + 0.6 * f32(i32(tree.spruce && i > 0)); // twigs of spruces lie flat
        let squeeze = vec3f(1.0, wide, 1.0) / scales[i];
        var n = value_noise3_grad(q * squeeze + origin, 31u + u32(i)) * vec4f(1.0, squeeze);
        n *= 0.5 * presence * amplitudes[i];
        sum += n + vec4f(0.5 * amplitudes[i], 0.0, 0.0, 0.0);
    }
    if tree.spruce {
        // Little is eaten off the leader: spruces are pointed.
        let below = (tree.height - q.y) / (SPRUCE_LEADER * tree.height);
        let held = 0.02 + 0.98 * clamp(below, 0.0, 1.0);
        let fall = select(0.0, 0.98 / (SPRUCE_LEADER * tree.height), below > 0.0 && below < 1.0);
        sum = vec4f(held * sum.x, held * sum.y, held * sum.z - fall * sum.x, held * sum.w);
    }
    return sum;
}

/// How deep each size of leaves eats into a crown (m): boughs, tufts, leaves.
fn crown_amplitudes(tree: Tree) -> vec3f {
    if tree.spruce {
        return vec3f(0.10 * tree.radius, 0.45 * trees.tuft, 0.30 * trees.tuft);
    }
    return vec3f(0.46 * tree.radius, 1.15 * trees.tuft, 0.50 * trees.tuft);
}

/// How far apart each size of leaves repeats (m).
fn crown_scales(tree: Tree) -> vec3f {
    if tree.spruce {
        return vec3f(0.34 * tree.radius, 0.70 * trees.tuft, 0.26 * trees.tuft);
    }
    return vec3f(0.46 * tree.radius, 0.95 * trees.tuft, 0.28 * trees.tuft);
}

/// The steepest that `crown_hull` + `crown_leaves` can be.
///
/// Value noise in space has no gradient longer than 3.75 (its longest partial derivative; tested, not proven, for all
/// three together).
fn crown_steepness(tree: Tree) -> f32 {
    let scales = crown_scales(tree);
    let flat_twigs = select(vec3f(1.0), vec3f(1.0, 1.6, 1.6), tree.spruce);
    var steepest = 1.0 + 0.5 * 3.75 * dot(crown_amplitudes(tree) / scales, flat_twigs);
    if tree.spruce {
        let eaten = dot(crown_amplitudes(tree), vec3f(1.0));
        steepest += SPRUCE_STEEPNESS - 1.0 + 0.98 / (SPRUCE_LEADER * tree.height) * eaten;
    }
    return steepest * (1.0 + 1.7 * trees.sway / tree.height); // a bent crown is sheared
}

/// The crown with its leaves: (value, gradient) at `q` (m from the foot); negative inside, at most `crown_steepness`
/// steep.
fn crown_field(tree: Tree, q: vec3f, footprint: f32) -> vec4f {
    let bent = tree_sway(tree, q.y);
    let upright = q - vec3f(bent.x, 0.0, bent.y);
    return crown_hull(tree, upright, footprint) + crown_leaves(tree, upright, footprint);
}

/// Distance (m) to the upright cylinder that a tree keeps to, leaves and trunk included (a crown that sways out of it
/// is cut off there); a lower bound, gradient at most 1.
fn tree_room(tree: Tree, q: vec3f) -> f32 {
    return max(length(q.xz) - tree.radius, max(q.y - tree.height, -TREE_ROOT - q.y));
}

/// A lower bound of the distance to a tree (m) at `q` (m from its foot), negative inside; gradient at most 1.
fn tree_distance(tree: Tree, q: vec3f, footprint: f32) -> f32 {
    let room = tree_room(tree, q);
    let crown = crown_field(tree, q, footprint).x / crown_steepness(tree);
    let top = tree.crown + 0.4 * (tree.height - tree.crown);
    let trunk = max(length(q.xz) - tree.trunk, max(q.y - top, -TREE_ROOT - q.y));
    return max(room, min(crown, trunk));
}
