// Trees: how a ray finds them, what they leave of the sun, and how they look.

#include <camera/camera.wgsl>
#include <light/daylight.wgsl>
#include <light/outdoor.wgsl>
#include <quality.wgsl>
#include <terrain/height.wgsl>
#include <trees/cover.wgsl>
#include <trees/tree.wgsl>

/// How far away trees are still drawn one by one; from two thirds of it on they give way to the ground's cover.
#param trees.far: f32 = 3000.0, range 10 .. 20000, log, unit m
/// How far trees throw shadows.
#param trees.shadow_reach: f32 = 140.0, range 1 .. 2000, log, unit m
/// How dense leaves are to light: a metre of broadleaved crown leaves exp(-1 / this) of it; spruces are half as dense
/// again.
#param trees.clearness: f32 = 1.7, range 0.05 .. 50, log, unit m
/// Albedo of spruce needles.
#param trees.needle: vec3f = (0.030, 0.052, 0.020), color
/// Albedo of green leaves.
#param trees.leaf: vec3f = (0.055, 0.086, 0.024), color
/// Albedo of bark.
#param trees.bark: vec3f = (0.11, 0.085, 0.065), color

#if quality == low
const TREE_LEAST: f32 = 9.0; // pixels that the tallest trees stand up to where trees are drawn one by one
const TREE_DETAIL: f32 = 2.5; // width of the smallest detail looked at, in pixels
const TREE_STEPS: i32 = 80; // cells looked at along a ray
const TREE_CROWNS: i32 = 8; // crowns marched through
const TREE_MARCH: i32 = 6; // steps in each
const TREE_STRIDE: f32 = 0.9; // part of the crown's field that a step covers
const TREE_CLIMB: f32 = 0.6; // steepest ground that trees are looked for behind
const TREE_STEEPENING: f32 = 0.35; // by how much it may be steeper than here
const TREE_PROBES: i32 = 24; // cells from one look at the ground to the next
const TREE_CLEARANCE: f32 = 1.5; // as high above the land, in heights of the tallest, no tree is looked for
const TREE_GLADE: f32 = 0.7; // how wide, in patches, a clearing of depth -1 is taken to be; 0 where every cell is looked at
const TREE_SHADOW_STEPS: i32 = 16;
const TREE_SHADES: i32 = 2; // crowns looked through to the sun
const TREE_LOOKS: i32 = 1; // looks at each
#elif quality == medium
const TREE_LEAST: f32 = 0.0;
const TREE_DETAIL: f32 = 1.0;
const TREE_STEPS: i32 = 1000;
const TREE_CROWNS: i32 = 16;
const TREE_MARCH: i32 = 28;
const TREE_STRIDE: f32 = 0.65;
const TREE_CLIMB: f32 = 0.8;
const TREE_STEEPENING: f32 = 9.0;
const TREE_PROBES: i32 = 12;
const TREE_CLEARANCE: f32 = 3.0;
const TREE_GLADE: f32 = 0.0;
const TREE_SHADOW_STEPS: i32 = 120;
const TREE_SHADES: i32 = 16;
const TREE_LOOKS: i32 = 3;
#elif quality == high
const TREE_LEAST: f32 = 0.0;
const TREE_DETAIL: f32 = 1.0;
const TREE_STEPS: i32 = 1600;
const TREE_CROWNS: i32 = 24;
const TREE_MARCH: i32 = 44;
const TREE_STRIDE: f32 = 0.5;
const TREE_CLIMB: f32 = 1.0;
const TREE_STEEPENING: f32 = 9.0;
const TREE_PROBES: i32 = 12;
const TREE_CLEARANCE: f32 = 3.0;
const TREE_GLADE: f32 = 0.0;
const TREE_SHADOW_STEPS: i32 = 160;
const TREE_SHADES: i32 = 24;
const TREE_LOOKS: i32 = 4;
#else
const TREE_LEAST: f32 = 0.0;
const TREE_DETAIL: f32 = 1.0;
const TREE_STEPS: i32 = 3000;
const TREE_CROWNS: i32 = 40;
const TREE_MARCH: i32 = 90;
const TREE_STRIDE: f32 = 0.35;
const TREE_CLIMB: f32 = 1.5;
const TREE_STEEPENING: f32 = 9.0;
const TREE_PROBES: i32 = 12;
const TREE_CLEARANCE: f32 = 3.0;
const TREE_GLADE: f32 = 0.0;
const TREE_SHADOW_STEPS: i32 = 300;
const TREE_SHADES: i32 = 40;
const TREE_LOOKS: i32 = 8;
#endif

/// How far away (m) trees are drawn one by one.
fn trees_end() -> f32 {
    return min(trees.far, trees.tallest / max(TREE_LEAST * camera_pixel_angle(), 1e-9));
}

/// How high above the land (m) a ray needs to ask for no trees: more than they are tall, as the land may rise between two
/// steps of its march (tested, not proven).
fn trees_clearance() -> f32 {
    return TREE_CLEARANCE * trees.tallest;
}

/// What a ray met.
struct TreeHit {
    /// Distance along the ray (m); how far was looked, if nothing was met.
    distance: f32,
    /// Whether a crown or a trunk was met.
    hit: bool,
    /// Cells looked at, and steps in crowns.
    steps: i32,
    /// The tree's; 0 for none.
    id: u32,
    /// The tree.
    tree: Tree,
    /// Whether it is the trunk.
    bark: bool,
    /// Unit normal of the ground that the tree stands on.
    ground: vec3f,
}

/// A walk along a ray through the cells of the grid, row by row.
struct TreeWalk {
    origin: vec3f,
    direction: vec3f,
    near: f32,
    far: f32,
    // The axis of the map that the ray follows more than the other: rows are numbered along it.
    eastward: bool,
    row: i32,
    last_row: i32,
    lane: i32,
    last_lane: i32,
    step: i32,
    // Cells passed since the ground was last looked at.
    unprobed: i32,
    // Where the ground was looked at last; its height there and its slope.
    looked: vec2f,
    land: vec3f,
    // Normal of the ground under the tree found.
    ground: vec3f,
    steps: i32,
}

/// A walk from `near` to `far` (m) along a ray.
fn trees_walk(origin: vec3f, direction: vec3f, near: f32, far: f32) -> TreeWalk {
    var walk: TreeWalk;
    walk.origin = origin;
    walk.direction = direction;
    walk.near = near;
    walk.far = far;
    // From above nothing is met before the tops of trees on the highest ground, nor once above them.
    let top = min(terrain_ceiling(), trees.highest + 2.0 * trees.raggedness) + trees.tallest;
    if abs(direction.y) > 1e-6 {
        let at_top = (top - origin.y) / direction.y;
        walk.near = select(near, max(near, at_top), direction.y < 0.0);
        walk.far = select(far, min(far, at_top), direction.y > 0.0);
    } else if origin.y > top {
        walk.far = near - 1.0;
    }
    walk.eastward = abs(direction.x) > abs(direction.z);
    walk.step = select(-1, 1, select(direction.z, direction.x, walk.eastward) >= 0.0);
    walk.row = trees_row_at(walk, walk.near) - walk.step;
    walk.last_row = trees_row_at(walk, walk.far) + walk.step;
    walk.lane = 1;
    walk.last_lane = 0;
    walk.unprobed = 1000;
    walk.looked = vec2f(1e9);
    walk.ground = vec3f(0.0, 1.0, 0.0);
    // The first call of `trees_next` goes one row on.
    walk.row -= walk.step;
    return walk;
}

/// The row that a ray is in at `t` (m).
fn trees_row_at(walk: TreeWalk, t: f32) -> i32 {
    let p = walk.origin + t * walk.direction;
    return i32(floor(select(p.z, p.x, walk.eastward) / trees.spacing));
}

/// Sets the lanes of a row that hold trees which the ray may meet.
fn trees_lanes(walk: ptr<function, TreeWalk>) {
    let w = *walk;
    let start = select(w.origin.zx, w.origin.xz, w.eastward); // (along, across)
    let heading = select(w.direction.zx, w.direction.xz, w.eastward);
    let along = select(-1.0, 1.0, heading.x >= 0.0) * max(abs(heading.x), 1e-6);
    let edges = (vec2f(f32(w.row)) + vec2f(-TREE_OVERHANG, 1.0 + TREE_OVERHANG)) * trees.spacing;
    let times = clamp((edges - vec2f(start.x)) / along, vec2f(w.near), vec2f(w.far));
    let across = (vec2f(start.y) + times * heading.y) / trees.spacing;
    (*walk).lane = i32(floor(min(across.x, across.y) - TREE_OVERHANG));
    (*walk).last_lane = min(i32(floor(max(across.x, across.y) + TREE_OVERHANG)), (*walk).lane + 7);
}

/// The next tree whose room the ray passes through; `found` is false when the walk is over.
struct TreeMet {
    /// The tree, with its foot on the ground.
    tree: Tree,
    /// Where the ray enters the upright cylinder around it, and leaves it (m).
    enters: f32,
    leaves: f32,
    found: bool,
}

/// Walks on to the next tree.
///
/// Cells whose tree the ray passes at more than a crown's width cost a hash; the woods are asked next, and only then
/// the ground. Where the ray is high above the trees, or in a wide clearing, it skips rows. `patience`: cells looked at
/// most in all; `thinning`: distance (m) from which on trees begin to be left out.
fn trees_next(walk: ptr<function, TreeWalk>, patience: i32, thinning: f32) -> TreeMet {
    var met: TreeMet;
    let origin = (*walk).origin;
    let direction = (*walk).direction;
    let level2 = max(dot(direction.xz, direction.xz), 1e-12);
    let level = sqrt(level2);
    let descent = -direction.y / level;
    for (var i = 0; i < patience; i++) {
        // On to a cell that is worth a look at the ground. A loop of its own: where pixels are drawn together, they look
        // together.
        var tree: Tree;
        var nearest = 0.0;
        var offset = 0.0;
        var candidate = false;
        var probe = false;
        for (var j = 0; j < patience && !candidate && !probe; j++) {
            if (*walk).steps >= patience {
                break;
            }
            (*walk).steps += 1;
            if (*walk).lane > (*walk).last_lane {
                if (*walk).far <= (*walk).near || ((*walk).last_row - (*walk).row) * (*walk).step <= 0 {
                    break;
                }
                (*walk).row += (*walk).step;
                trees_lanes(walk);
            }
            var cell = vec2i((*walk).lane, (*walk).row);
            if (*walk).eastward {
                cell = cell.yx;
            }
            (*walk).lane += 1;
            (*walk).unprobed += 1;
            tree = tree_in_cell(cell);

            let to_tree = tree.foot.xz - origin.xz;
            nearest = clamp(dot(to_tree, direction.xz) / level2, (*walk).near, (*walk).far);
            offset = length(to_tree - nearest * direction.xz);
            candidate = offset < tree.radius;
            if candidate && thinning > 0.0 {
                candidate = nearest < thinning * (1.0 + 0.5 * unit_float(pcg(tree.id)));
            }
            // From what the ground was like a few cells ago it may be seen that the ray passes above.
            let off = tree.foot.xz - (*walk).looked;
            let top = (*walk).land.x + dot((*walk).land.yz, off) + TREE_STEEPENING * length(off) + tree.height;
            let stale = (*walk).unprobed > TREE_PROBES;
            candidate = candidate && (stale || origin.y + nearest * direction.y - abs(descent) * tree.radius < top);
            probe = !candidate && stale;
        }
        if !candidate && !probe {
            break;
        }
        var depth = 0.0;
        var ahead = (*walk).near; // where the next tree may be met (m)
        var above = false; // whether that is for the ray's height
        if candidate || TREE_GLADE > 0.0 {
            let stale = (*walk).unprobed > TREE_PROBES;
            depth = woods_depth(tree.foot.xz);
            let glade = -depth * TREE_GLADE * trees.patch;
            if glade > trees.spacing {
                ahead = nearest + glade / level;
            }
            candidate = candidate && tree.chance < woods_density(depth);
            probe = !candidate && stale;
        }
        if candidate || probe {
            if candidate {
                tree = tree_grow(tree, depth);
                candidate = offset < tree.radius;
            }
            let half_chord = sqrt(max(tree.radius * tree.radius - offset * offset, 0.0)) / level;
            let enters = max(nearest - half_chord, (*walk).near);
            let leaves = min(nearest + half_chord, (*walk).far);
            let y_enters = origin.y + enters * direction.y;
            let y_leaves = origin.y + leaves * direction.y;
            let low = min(y_enters, y_leaves);
            let high = max(y_enters, y_leaves);
            (*walk).unprobed = 0;

            let land = terrain_height_grad_filtered(tree.foot.xz, trees.spacing);
            (*walk).looked = tree.foot.xz;
            (*walk).land = land;
            if candidate && low <= land.x + tree.height && high >= land.x - TREE_ROOT {
                tree.foot.y = land.x;
                let normal = normalize(vec3f(-land.y, 1.0, -land.z));
                if tree.chance < woods_density(depth) * woods_limits(land.x, normal.y, depth) {
                    (*walk).ground = normal;
                    met.tree = tree;
                    met.enters = enters;
                    met.leaves = leaves;
                    met.found = true;
                    break;
                }
            }
            let clear = low - land.x - trees.tallest;
            if clear > trees.spacing {
                // High above the trees: as far on as the ground would need to rise to here.
                let rise = dot(land.yz, direction.xz) / level;
                let closing = min(TREE_CLIMB, max(rise, 0.0) + TREE_STEEPENING) + descent;
                if closing <= 0.0 {
                    break;
                }
                above = true;
                ahead = max(ahead, nearest + clear / (closing * level));
            }
        }
        if ahead >= (*walk).far {
            break;
        }
        let row = trees_row_at(*walk, ahead) - (*walk).step;
        let rows = (row - (*walk).row) * (*walk).step;
        if rows > 0 {
            (*walk).row = row - (*walk).step;
            (*walk).lane = 1;
            (*walk).last_lane = 0;
            (*walk).unprobed = select((*walk).unprobed + rows, 1000, above);
        }
    }
    return met;
}

/// The first crown or trunk between `near` and `far` (m) along a ray; `direction` is a unit vector.
///
/// Trees narrower than a pixel or two, from two thirds of `trees.far` on, are left out one by one. Details are
/// filtered to the pixel. A ray that starts inside of a crown meets it at once.
fn trees_trace(origin: vec3f, direction: vec3f, near: f32, far: f32) -> TreeHit {
    var walk = trees_walk(origin, direction, near, min(far, trees_end()));
    let pixel_angle = TREE_DETAIL * camera_pixel_angle();
    var result: TreeHit;
    result.distance = far;
    var marched = 0;
    for (var i = 0; i < TREE_CROWNS; i++) {
        let met = trees_next(&walk, TREE_STEPS, 0.667 * trees_end());
        if !met.found {
            break;
        }
        let tree = met.tree;
        let start = origin - tree.foot;
        var found = far;
        var bark = false;

        // The trunk: a cylinder.
        let level2 = dot(direction.xz, direction.xz);
        let to_axis = -dot(start.xz, direction.xz) / max(level2, 1e-12);
        let offset = length(start.xz + to_axis * direction.xz);
        let trunk = max(tree.trunk, 0.3 * pixel_angle * met.enters);
        if offset < trunk {
            let chord = sqrt((trunk * trunk - offset * offset) / max(level2, 1e-12));
            let t = max(to_axis - chord, met.enters);
            let y = start.y + t * direction.y;
            if t < met.leaves && y > -TREE_ROOT && y < tree.crown + 0.4 * (tree.height - tree.crown) {
                found = t;
                bark = true;
            }
        }

        // The crown, from where the ray enters its room.
        var t = met.enters;
        var leaves = min(met.leaves, found);
        if abs(direction.y) > 1e-6 {
            let heights = (vec2f(tree.crown, tree.height) - vec2f(start.y)) / direction.y;
            t = max(t, min(heights.x, heights.y));
            leaves = min(leaves, max(heights.x, heights.y));
        } else if start.y < tree.crown || start.y > tree.height {
            leaves = t - 1.0;
        }
        for (var k = 1; k <= TREE_MARCH; k++) {
            if t > leaves {
                break;
            }
            marched += 1;
            let footprint = t * pixel_angle;
            let field = crown_field(tree, start + t * direction, footprint).x;
            // Out of steps: they are short only where the ray grazes leaves.
            if field < 0.5 * footprint + select(0.01, 0.15, k == TREE_MARCH) {
                found = t;
                bark = false;
                break;
            }
            t += max(TREE_STRIDE * field, 0.35 * footprint + 0.02);
        }
        if found < result.distance {
            result.distance = found;
            result.hit = true;
            result.id = tree.id;
            result.tree = tree;
            result.bark = bark;
            result.ground = walk.ground;
            walk.far = min(walk.far, found);
            walk.last_row = trees_row_at(walk, walk.far) + walk.step;
        }
    }
    result.steps = walk.steps + marched;
    return result;
}

/// Part of the sun that the trees leave to `position` (m), 0 .. 1, seen by a pixel `footprint` (m) wide.
///
/// Light is lost along its way through leaves: exp(-length / `trees.clearness`), with the leaves as the crowns have
/// them, blurred by the sun's width the farther off the more. Beyond where single trees are drawn: 1.
fn trees_shadow(position: vec3f, footprint: f32, day: Daylight) -> f32 {
    let to_sun = day.to_sun;
    let drawn = trees_end() * camera_pixel_angle();
    let fade = 1.0 - smoothstep(0.5 * drawn, drawn, footprint);
    if to_sun.y <= 0.0 || fade <= 0.0 {
        return 1.0;
    }
    var walk = trees_walk(position, to_sun, 0.02, trees.shadow_reach);
    var thickness = 0.0; // optical
    for (var i = 0; i < TREE_SHADES; i++) {
        if thickness > 5.0 {
            break;
        }
        let met = trees_next(&walk, TREE_SHADOW_STEPS, 0.0);
        if !met.found {
            break;
        }
        let tree = met.tree;
        let start = position - tree.foot;
        var enters = met.enters;
        var leaves = met.leaves;
        let heights = (vec2f(tree.crown, tree.height) - vec2f(start.y)) / max(to_sun.y, 1e-4);
        enters = max(enters, heights.x);
        leaves = min(leaves, heights.y);

        // The trunk, softened by the sun's width.
        let level2 = max(dot(to_sun.xz, to_sun.xz), 1e-12);
        let to_axis = -dot(start.xz, to_sun.xz) / level2;
        let offset = length(start.xz + to_axis * to_sun.xz);
        let y = start.y + to_axis * to_sun.y;
        if to_axis > met.enters && y > 0.0 && y < tree.crown + 1.0 {
            let blur = day.radius * to_axis + 0.5 * footprint + 0.01;
            thickness += 4.0 * min(tree.trunk / blur, 1.0) * (1.0 - smoothstep(-blur, blur, offset - tree.trunk));
        }
        if leaves <= enters {
            continue;
        }
        let step = (leaves - enters) / f32(TREE_LOOKS);
        var passed = 0.0;
        for (var k = 0; k < TREE_LOOKS; k++) {
            let t = enters + (f32(k) + 0.5) * step;
            let blur = 0.12 + day.radius * t + 0.5 * footprint;
            let field = crown_field(tree, start + t * to_sun, 2.0 * blur).x;
            passed += 1.0 - smoothstep(-blur, blur, field);
        }
        thickness += passed * step / trees.clearness * select(1.0, 1.5, tree.spruce);
    }
    return mix(1.0, exp(-thickness), fade);
}

/// Radiance of a tree that a ray met, in the light of `day`, without haze; `sun_seen`: what the land and the trees leave
/// of the sun.
///
/// Leaves reflect and let through about as much: a crown against the sun glows. What lies deep in the crown, or low
/// in the woods, sees less of the sky.
fn trees_shade(origin: vec3f, direction: vec3f, hit: TreeHit, day: Daylight, sun_seen: f32) -> vec3f {
    let position = origin + hit.distance * direction;
    let tree = hit.tree;
    let q = position - tree.foot;
    let to_sun = day.to_sun;
    let footprint = TREE_DETAIL * hit.distance * camera_pixel_angle();
    let up = clamp(q.y / tree.height, 0.0, 1.0);
    let dice = unit_float3(pcg3d(vec3u(tree.id, 11u, 13u)));
    if hit.bark {
        let axis = normalize_or(vec3f(q.x, 0.0, q.z), vec3f(0.0, 0.0, 1.0));
        let grain = value_noise3(vec3f(14.0, 2.5, 14.0) * q + 30.0 * dice, 51u);
        let albedo = trees.bark * (0.8 + 0.5 * dice.x) * (1.0 + 0.4 * grain);
        let open = 0.35;
        return outdoor_radiance(
            albedo, axis, to_sun, day.sun, day.sky, sun_seen, open, vec3f(0.04, 0.05, 0.02),
        );
    }
    let hull = crown_hull(tree, q, footprint);
    let ragged = crown_leaves(tree, q, footprint);
    let round = normalize_or(hull.yzw, vec3f(0.0, 1.0, 0.0));
    let leafy = normalize_or(hull.yzw + 0.75 * ragged.yzw, round);
    let far_off = smoothstep(0.1, 1.5, footprint);
    let normal = normalize_or(mix(mix(round, leafy, 0.8), hit.ground, 0.12 + 0.3 * far_off), vec3f(0.0, 1.0, 0.0));

    // Colour, tree by tree and tuft by tuft.
    let tuft = value_noise3(q / (1.1 * trees.tuft) + 30.0 * dice, 53u);
    let blotch = tuft * (1.0 - smoothstep(0.3, 1.5, footprint / trees.tuft));
    var leaf = trees.needle * mix(vec3f(0.85, 0.95, 1.15), vec3f(1.25, 1.1, 0.8), dice.x);
    var through = 0.25 * leaf;
    if !tree.spruce {
        let green = trees.leaf * mix(vec3f(0.75, 0.88, 1.0), vec3f(1.35, 1.08, 0.8), dice.x);
        let turned = clamp(2.2 * trees.autumn - 1.2 * dice.y + 0.35 * (up - 0.5) + 0.25 * blotch, 0.0, 1.0);
        leaf = mix(green, autumn_leaf(fract(dice.y * 7.0)), turned * trees.autumn);
        through = leaf * vec3f(1.05, 1.0, 0.45);
    }
    leaf *= (0.75 + 0.5 * dice.z) * (1.0 + 0.25 * blotch);
    // Single leaves turn to the light or away from it, and between them it is dark.
    let leaf_size = select(0.16, 0.09, tree.spruce);
    let resolved = 1.0 - smoothstep(0.5, 2.0, footprint / leaf_size);
    let sparkle = value_noise3(q / leaf_size + 50.0 * dice.zxy, 57u) + value_noise3(2.7 * q / leaf_size, 59u);
    let turned_up = 1.0 + resolved * clamp(1.1 * sparkle, -0.8, 1.0);
    through *= 0.75 + 0.5 * dice.z;

    // Depth below the hull that leaves leave on average, in m.
    let outside = select(hull.x, spruce_cone(tree, q).x, tree.spruce);
    let deep = max(-0.35 * dot(crown_amplitudes(tree), vec3f(1.0)) - outside, 0.0);
    let open = exp(-0.9 * deep / trees.clearness) * mix(0.35, 1.0, up * up) * (0.75 + 0.25 * normal.y);
    let facing = dot(normal, to_sun);
    let lit = day.sun * sun_seen;
    let reflected = max(facing, 0.0) * 0.85 + 0.15 * max(facing + 0.5, 0.0); // leaves stand at all angles
    let glow = max(0.35 - 0.65 * facing, 0.0) * (0.5 + 0.5 * smoothstep(-0.2, 0.9, dot(direction, to_sun)));
    let ambient = day.sky * (0.5 + 0.5 * normal.y) * open;
    let bounce = 0.05 * day.sun * max(to_sun.y, 0.0) * (0.5 - 0.5 * normal.y) * open;
    return turned_up * (leaf * (lit * reflected + ambient + bounce) + through * lit * glow) / 3.14159265;
}

/// The tree of a cell as it stands, with its foot on the ground; `found` is false where none does. One height of the
/// land.
fn trees_standing(cell: vec2i) -> TreeMet {
    var met: TreeMet;
    let sapling = tree_in_cell(cell);
    let depth = woods_depth(sapling.foot.xz);
    if sapling.chance >= woods_density(depth) {
        return met;
    }
    let land = terrain_height_grad_filtered(sapling.foot.xz, trees.spacing);
    let normal_y = inverseSqrt(1.0 + dot(land.yz, land.yz));
    met.tree = tree_grow(sapling, depth);
    met.tree.foot.y = land.x;
    met.found = met.tree.chance < woods_density(depth) * woods_limits(land.x, normal_y, depth);
    return met;
}

/// A lower bound of the distance (m) from `p` (m) to the nearest tree, negative inside; gradient at most 1.
///
/// Looks at 3×3 cells, and leaves out those whose trees are farther than what is found already. Trees beyond reach
/// out of their cells by less than half a cell, so that none is nearer than .54 cells and the way to the edge of this
/// one; more is never returned. Up to 9 heights of the land: for tests and views; rays walk row by row instead.
fn trees_sdf(p: vec3f, footprint: f32) -> f32 {
    let here = p.xz / trees.spacing;
    let cell = floor(here);
    let inner = here - cell;
    let edge = min(min(inner.x, inner.y), min(1.0 - inner.x, 1.0 - inner.y));
    var nearest = (1.0 - TREE_OVERHANG + edge) * trees.spacing;
    for (var i = 0; i < 9; i++) {
        let neighbour = vec2i(cell) + vec2i(i % 3 - 1, i / 3 - 1);
        let sapling = tree_in_cell(neighbour);
        if length(p.xz - sapling.foot.xz) - sapling.radius > nearest {
            continue;
        }
        let met = trees_standing(neighbour);
        if met.found {
            nearest = min(nearest, tree_distance(met.tree, p - met.tree.foot, footprint));
        }
    }
    return nearest;
}
