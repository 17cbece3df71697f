//! Trees: distances, rays, where they stand.

use orogen::Preset;
use truth::points::Random;
use truth::trees::{ellipse_bound, ellipse_bound_slope, ellipse_distance};

use crate::harness::{Report, Scope, value, values};

const TREES: &[&str] = &["<trees/trees.wgsl>"];

/// Hills with woods that run into all of their limits: water, tree line and slopes too steep.
fn hills() -> Preset {
    let text = r#"{
        "orogen": 1, "about": "", "scene": "scene/landscape.wgsl",
        "set": {
            "landscape": { "trees": true },
            "terrain": {
                "relief": "damped", "seed": 11, "scale": 2500, "peak_height": 450, "gully_depth": 30, "detail": 15
            },
            "trees": { "share": 0.75, "lowest": 180, "highest": 290, "raggedness": 40, "steepest": 24, "patch": 300 }
        }
    }"#;
    Preset::parse("hills.json", text).unwrap()
}

/// The same hills without limits, the trees close together.
fn woods() -> Preset {
    let mut preset = hills();
    for assignment in ["trees.share=0.95", "trees.lowest=-900", "trees.highest=4000", "trees.steepest=80"] {
        preset.set(assignment).unwrap();
    }
    preset
}

fn largest(rows: &[Vec<f64>], what: impl Fn(&[f64]) -> f64) -> f64 {
    rows.iter().map(|row| what(row)).fold(f64::NEG_INFINITY, |most, value| {
        if most.is_nan() || value.is_nan() { f64::NAN } else { most.max(value) }
    })
}

const BRUTE_FORCE: &str = r#"
#include <math/rotation.wgsl>
#include <sky/sky.wgsl>
#include <terrain/height.wgsl>
#include <trees/trees.wgsl>

// The nearest of all trees in 5×5 cells.
fn brute_sdf(p: vec3f) -> f32 {
    let cell = vec2i(floor(p.xz / trees.spacing));
    var nearest = 1e9;
    for (var i = 0; i < 25; i++) {
        let met = trees_standing(cell + vec2i(i % 5 - 2, i / 5 - 2));
        if met.found {
            nearest = min(nearest, tree_distance(met.tree, p - met.tree.foot, 0.0));
        }
    }
    return nearest;
}

fn above_ground(x: f32, y: f32, z: f32) -> vec3f {
    return vec3f(x, terrain_height_filtered(vec2f(x, z), trees.spacing) + y, z);
}

fn sdf_and_brute(x: f32, y: f32, z: f32) -> vec2f {
    let p = above_ground(x, y, z);
    return vec2f(trees_sdf(p, 0.0), brute_sdf(p));
}

// (slope, distance): the slope along the gradient, both by central differences over 6 cm. (The length of the gradient
// by differences would exceed the slope where two trees are equally far: its components belong to both.)
fn sdf_slope(x: f32, y: f32, z: f32) -> vec2f {
    let p = above_ground(x, y, z);
    var gradient = vec3f(0.0);
    var slope = 0.0;
    var ahead = 0.0;
    for (var i = 0; i < 8; i++) {
        var offset = vec3f(0.0);
        if i < 6 {
            offset[i / 2] = 1.0;
        } else {
            offset = normalize_or(gradient, vec3f(0.0, 1.0, 0.0));
        }
        let value = trees_sdf(p + select(-0.03125, 0.03125, (i & 1) == 0) * offset, 0.0);
        if (i & 1) == 0 {
            ahead = value;
        } else if i < 6 {
            gradient[i / 2] = ahead - value;
        } else {
            slope = (ahead - value) / 0.0625;
        }
    }
    return vec2f(slope, trees_sdf(p, 0.0));
}
"#;

#[test]
fn the_distance_to_the_trees_is_at_most_that_by_brute_force() {
    let mut report = Report::new("Trees", "the_distance_to_the_trees_is_at_most_that_by_brute_force");
    let mut random = Random::new(301);
    for (name, preset) in [("hills", hills()), ("closed woods", woods())] {
        let scope = Scope { includes: TREES, fragment: BRUTE_FORCE, preset: Some(&preset) };
        let points: Vec<_> = (0..6000)
            .map(|_| [random.within(-400.0, 400.0), random.within(-5.0, 32.0), random.within(-400.0, 400.0)])
            .collect();
        let both = values("sdf_and_brute(x, y, z)", &scope, ["x", "y", "z"], &points);
        report.at_most(
            &format!("{name}: `trees_sdf` − brute force over 5×5 cells, m"),
            largest(&both, |row| row[0] - row[1]),
            1e-5,
        );
        let equal =
            both.iter().filter(|row| (row[0] - row[1]).abs() < 1e-5).count() as f64 / both.len() as f64;
        report.told(&format!("{name}: part of the points where both are equal"), equal);
        let inside = both.iter().filter(|row| row[0] < 0.0).count() as f64 / both.len() as f64;
        report.at_least(&format!("{name}: part of the points inside of a tree"), inside, 0.02);
    }
    report.finish();
}

#[test]
fn the_distance_to_the_trees_is_never_steeper_than_one() {
    let mut report = Report::new("Trees", "the_distance_to_the_trees_is_never_steeper_than_one");
    let mut preset = woods();
    // Low hills around the origin, where an f32 resolves micrometres.
    for assignment in ["terrain.peak_height=30", "terrain.detail=2", "terrain.gully_depth=0"] {
        preset.set(assignment).unwrap();
    }
    let scope = Scope { includes: TREES, fragment: BRUTE_FORCE, preset: Some(&preset) };
    let mut random = Random::new(302);
    let points: Vec<_> = (0..8000)
        .map(|_| [random.within(-60.0, 60.0), random.within(0.0, 32.0), random.within(-60.0, 60.0)])
        .collect();
    let slopes = values("sdf_slope(x, y, z)", &scope, ["x", "y", "z"], &points);
    let outside: Vec<_> = slopes.into_iter().filter(|row| row[1] > 0.05).collect();
    report.at_least("points outside of all trees", outside.len() as f64, 2000.0);
    report.at_most("steepest slope of `trees_sdf` outside", largest(&outside, |row| row[0]), 1.001);
    report.finish();
}

#[test]
fn a_crown_is_nowhere_nearer_than_its_ellipsoid() {
    let mut report = Report::new("Trees", "a_crown_is_nowhere_nearer_than_its_ellipsoid");
    let fragment = r#"
#include <trees/tree.wgsl>
fn crown_at(x: f32, y: f32, radius: f32, height: f32) -> f32 {
    var tree: Tree;
    tree.height = height;
    tree.radius = radius;
    tree.crown = 0.2 * height;
    return crown_hull(tree, vec3f(x, y, 0.0), 0.0).x;
}
"#;
    let scope = Scope { includes: &["<trees/tree.wgsl>"], fragment, preset: None };
    let mut random = Random::new(303);
    let points: Vec<_> = (0..20_000)
        .map(|_| {
            [
                random.within(-12.0, 12.0),
                random.within(-8.0, 30.0),
                random.within(1.0, 4.0),
                random.within(4.0, 24.0),
            ]
        })
        .collect();
    let hulls = values("crown_at(x, y, radius, height)", &scope, ["x", "y", "radius", "height"], &points);
    let (mut over, mut bound_over, mut steepest, mut outside) =
        (f64::NEG_INFINITY, f64::NEG_INFINITY, 0.0_f64, 0);
    for (point, hull) in points.iter().zip(&hulls) {
        let [x, y, radius, height] = point.map(f64::from);
        let half = 0.8 * height / 1.65;
        let up = y - (height - half);
        let radii = [radius, if up > 0.0 { half } else { 0.65 * half }];
        if (x / radii[0]).hypot(up / radii[1]) <= 1.0 {
            continue;
        }
        outside += 1;
        let truth = ellipse_distance([x, up], radii);
        over = over.max(hull[0] - truth);
        bound_over = bound_over.max(ellipse_bound([x, up], radii) - truth);
        steepest = steepest.max(ellipse_bound_slope([x, up], radii));
    }
    report.at_least("points outside", f64::from(outside), 5000.0);
    report.at_most("`crown_hull` − distance to the ellipsoid in f64, m", over, 1e-5);
    report.at_most("k₀ (k₀ − 1) / k₁ − distance, both in f64, m", bound_over, 1e-9);
    report.told("longest gradient of k₀ (k₀ − 1) / k₁, which is why it is not used", steepest);
    report.finish();
}

const RAYS: &str = r#"
#include <noise/pcg.wgsl>
#include <sky/sky.wgsl>
#include <terrain/height.wgsl>
#include <trees/trees.wgsl>

const REACH: f32 = 60.0; // m

fn ray_origin(seed: u32) -> vec3f {
    let u = unit_float3(pcg3d(vec3u(seed, 1u, 2u)));
    let xz = 500.0 * (u.xy - vec2f(0.5));
    return vec3f(xz.x, terrain_height_filtered(xz, trees.spacing) + 1.0 + 45.0 * u.z * u.z, xz.y);
}

fn ray_direction(seed: u32) -> vec3f {
    let u = unit_float2(pcg2d(vec2u(seed, 3u)));
    let y = 0.9 - 1.8 * u.x;
    return vec3f(sqrt(1.0 - y * y) * cos(6.2831853 * u.y), y, sqrt(1.0 - y * y) * sin(6.2831853 * u.y));
}

// Goes on along a ray by as much as the distance to the trees allows, 5 cm at least: (where it is, how long it has been
// inside, 1 if that is `chord` or else 0). A few steps: lavapipe ends every loop after
// 65,535 iterations of all of them.
fn dense(seed: u32, start: f32, inside: f32, chord: f32) -> vec3f {
    let origin = ray_origin(seed);
    let direction = ray_direction(seed);
    var t = start;
    var run = inside;
    for (var i = 0; i < 36; i++) {
        let distance = trees_sdf(origin + t * direction, t * camera_pixel_angle());
        if distance < 0.0 {
            run += 0.05;
            if run >= chord {
                return vec3f(t, run, 1.0);
            }
        } else {
            run = 0.0;
        }
        t += max(distance, 0.05);
    }
    return vec3f(t, run, 0.0);
}

// Where the march ends along a ray; 1e6 where it meets nothing.
fn marched(seed: u32) -> f32 {
    let hit = trees_trace(ray_origin(seed), ray_direction(seed), 0.0, REACH);
    return select(1e6, hit.distance, hit.hit);
}

// Along a ray: how far from the crowns and trunks the march ends, 0 where it meets none.
fn march_error(seed: u32) -> f32 {
    let origin = ray_origin(seed);
    let direction = ray_direction(seed);
    let hit = trees_trace(origin, direction, 0.0, REACH);
    if !hit.hit || hit.distance <= 0.0 {
        return 0.0;
    }
    return trees_sdf(origin + hit.distance * direction, hit.distance * camera_pixel_angle());
}
"#;

#[test]
fn rays_do_not_tunnel_through_trees() {
    let mut report = Report::new("Trees", "rays_do_not_tunnel_through_trees");
    let mut preset = woods();
    preset.set("trees.share=0.6").unwrap();
    let scope = Scope { includes: TREES, fragment: RAYS, preset: Some(&preset) };
    let seeds: Vec<_> = (0..3000).map(|seed| [seed as f32]).collect();
    let ends: Vec<f64> =
        values("marched(seed)", &scope, ["seed:u32"], &seeds).iter().map(|row| row[0]).collect();
    for (chord, allowed) in [(0.25, 0.005), (0.5, 0.0)] {
        // Where each ray has been inside of trees for so long, by as many short walks as that takes.
        let mut open: Vec<_> = (0..3000).map(|seed| [seed as f32, 0.0, 0.0, chord]).collect();
        let (mut met, mut passed) = (0, 0);
        while !open.is_empty() {
            let rows = values("dense(seed, t, run, chord)", &scope, ["seed:u32", "t", "run", "chord"], &open);
            let mut on = Vec::new();
            for ([seed, ..], row) in open.iter().zip(&rows) {
                if row[2] > 0.5 && row[0] < 60.0 {
                    met += 1;
                    passed += u32::from(ends[*seed as usize] > row[0] + 0.06);
                } else if row[0] < 60.0 {
                    on.push([*seed, row[0] as f32, row[1] as f32, chord]);
                }
            }
            open = on;
        }
        report.at_least(&format!("of 3,000 rays, those that meet {chord} m of tree"), f64::from(met), 500.0);
        let part = f64::from(passed) / f64::from(met.max(1));
        report.at_most(&format!("part of them that pass through {chord} m"), part, allowed);
    }
    let errors = values("march_error(seed)", &scope, ["seed:u32"], &seeds);
    report.at_most("farthest from a tree that a ray's end lies, m", largest(&errors, |row| row[0]), 0.05);
    report.finish();
}

#[test]
fn trees_stand_only_where_the_limits_allow() {
    let mut report = Report::new("Trees", "trees_stand_only_where_the_limits_allow");
    let fragment = r#"
#include <sky/sky.wgsl>
#include <terrain/height.wgsl>
#include <trees/trees.wgsl>

struct Stand { found: f32, height: f32, slope: f32, cover: f32, off: f32 }

// A cell's tree; its own ground's slope (rad), and what the cover says there.
fn stand(i: f32, j: f32) -> Stand {
    let cell = vec2i(i32(i), i32(j));
    let met = trees_standing(cell);
    let at = tree_in_cell(cell).foot.xz;
    var h = vec3f(0.0);
    for (var k = 0; k < 3; k++) {
        let beside = trees.spacing * vec2f(f32(i32(k == 1)), f32(i32(k == 2)));
        h[k] = terrain_height_filtered(at + beside, trees.spacing);
    }
    let slope = (h.yz - vec2f(h.x)) / trees.spacing;
    let normal = normalize(vec3f(-slope.x, 1.0, -slope.y));
    let middle = (vec2f(cell) + vec2f(0.5)) * trees.spacing;
    let off = max(abs(at.x - middle.x), abs(at.y - middle.y)) / trees.spacing
        + met.tree.radius / trees.spacing;
    return Stand(
        select(0.0, 1.0, met.found), h.x, length(slope), trees_cover(vec3f(at.x, h.x, at.y), normal),
        select(0.0, off, met.found),
    );
}
"#;
    let preset = hills();
    let scope = Scope { includes: TREES, fragment, preset: Some(&preset) };
    let cells: Vec<_> = (0..40_000).map(|k| [(k % 200 - 100) as f32, (k / 200 - 100) as f32]).collect();
    let rows = values("stand(i, j)", &scope, ["i", "j"], &cells);
    let standing: Vec<_> = rows.iter().filter(|row| row[0] > 0.5).cloned().collect();
    let bare = rows.iter().filter(|row| row[3] <= 0.0).count() as f64 / rows.len() as f64;
    report.at_least("trees in 40,000 cells", standing.len() as f64, 4000.0);
    report.at_least("part of the cells that the limits or clearings leave bare", bare, 0.1);
    report.at_least("lowest tree, m (waterline 180)", -largest(&standing, |row| -row[1]), 180.0);
    report.at_most("highest tree, m (tree line 290 + 40)", largest(&standing, |row| row[1]), 330.0);
    let steepest = largest(&standing, |row| row[2].atan().to_degrees());
    report.at_most("steepest ground under a tree, degrees (limit 24)", steepest, 24.01);
    report.at_least("least cover at a tree", -largest(&standing, |row| -row[3]), 1e-6);
    report.at_most(
        "farthest that a tree reaches from its cell's middle, cells",
        largest(&standing, |row| row[4]),
        0.96,
    );
    let cover = rows.iter().map(|row| row[3]).sum::<f64>() / rows.len() as f64;
    let share = standing.len() as f64 / rows.len() as f64;
    report.near("part of the cells with a tree, against the mean of `trees_cover`", share, cover, 0.01);
    report.finish();
}

#[test]
fn a_tree_is_the_same_tree_whatever_the_ray() {
    let mut report = Report::new("Trees", "a_tree_is_the_same_tree_whatever_the_ray");
    let fragment = format!(
        "{RAYS}{}",
        r#"
// (hit, apart from the tree that stands in that cell (m, ids included), apart from the hit that is found from a metre
// before (m))
fn same_tree(seed: u32) -> vec3f {
    let origin = ray_origin(seed);
    let direction = ray_direction(seed);
    var first: TreeHit;
    var again: TreeHit;
    for (var i = 0; i < 2; i++) {
        let hit = trees_trace(origin, direction, select(0.0, max(first.distance - 1.0, 0.0), i == 1), 60.0);
        if i == 0 {
            first = hit;
            if !hit.hit {
                return vec3f(0.0);
            }
        } else {
            again = hit;
        }
    }
    let cell = vec2i(floor(first.tree.foot.xz / trees.spacing));
    let stands = trees_standing(cell);
    let apart = length(stands.tree.foot - first.tree.foot) + f32(u32(stands.tree.id != first.id)) * 1000.0
        + select(1000.0, 0.0, stands.found);
    return vec3f(1.0, apart, select(1000.0, abs(again.distance - first.distance), again.hit && again.id == first.id));
}
"#
    );
    let preset = hills();
    let scope = Scope { includes: TREES, fragment: &fragment, preset: Some(&preset) };
    let seeds: Vec<_> = (0..4000).map(|seed| [seed as f32]).collect();
    let rows: Vec<_> = values("same_tree(seed)", &scope, ["seed:u32"], &seeds)
        .into_iter()
        .filter(|row| row[0] > 0.5)
        .collect();
    report.at_least("rays that meet a tree", rows.len() as f64, 800.0);
    // Compiled in two places, the same sums round in two ways.
    report.at_most("apart from the tree that stands in its cell, m", largest(&rows, |row| row[1]), 5e-5);
    let part = |limit: f64| rows.iter().filter(|row| row[2] > limit).count() as f64 / rows.len() as f64;
    report.at_most(
        "part of the rays that meet another tree when looking from a metre before the hit on",
        part(999.0),
        0.01,
    );
    report.told("part of the rays that then end more than 35 cm off", part(0.35));
    report.finish();
}

#[test]
fn trees_are_finite_from_anywhere() {
    let mut report = Report::new("Trees", "trees_are_finite_from_anywhere");
    let fragment = format!(
        "{RAYS}{}",
        r#"
// (least component of radiance and shadow, largest, hit): bad numbers come out as -1e9.
fn looked(seed: u32, place: u32) -> vec3f {
    var origin = ray_origin(seed);
    var direction = ray_direction(seed);
    let met = trees_standing(vec2i(floor(origin.xz / trees.spacing)));
    if place == 0u && met.found {
        origin = met.tree.foot + vec3f(0.2, 0.6 * met.tree.height, -0.1); // in a crown
    } else if place == 1u {
        origin.y -= 80.0;
    } else if place == 2u {
        direction = vec3f(0.0, select(-1.0, 1.0, (seed & 1u) == 0u), 0.0);
    } else if place == 3u {
        origin = origin - 100000.0 * direction;
    } else if place == 4u && met.found {
        origin = met.tree.foot + vec3f(0.0, 0.5 * met.tree.height, 0.0); // on its axis
        direction = vec3f(0.0, select(-1.0, 1.0, (seed & 1u) == 0u), 0.0);
    } else if place == 5u {
        direction = vec3f(select(-1.0, 1.0, (seed & 1u) == 0u), 0.0, 0.0);
    }
    let hit = trees_trace(origin, direction, 0.0, 200000.0);
    let shadow = trees_shadow(origin + hit.distance * direction, 0.1, sky_daylight(origin));
    let radiance = trees_shade(origin, direction, hit, sky_daylight(origin), shadow);
    let all = vec4f(select(vec3f(0.0), radiance, hit.hit), shadow);
    let bits = bitcast<vec4u>(all) & vec4u(0x7f800000u);
    if any(bits == vec4u(0x7f800000u)) || !(abs(hit.distance) < 1e9) {
        return vec3f(-1e9, 1e9, 0.0);
    }
    let least = min(min(all.x, all.y), min(all.z, all.w));
    return vec3f(least, max(max(all.x, all.y), max(all.z, all.w)), f32(u32(hit.hit)));
}
"#
    );
    let preset = hills();
    let scope = Scope { includes: TREES, fragment: &fragment, preset: Some(&preset) };
    let places =
        ["in crowns", "underground", "straight up and down", "100 km away", "along trunks", "along the grid"];
    let points: Vec<_> = (0..3000).map(|k| [k as f32, (k % 6) as f32]).collect();
    let rows = values("looked(seed, place)", &scope, ["seed:u32", "place:u32"], &points);
    for (place, name) in places.iter().enumerate() {
        let here: Vec<_> = rows.iter().skip(place).step_by(places.len()).cloned().collect();
        report.at_least(&format!("{name}: least radiance or light"), -largest(&here, |row| -row[0]), 0.0);
        report.at_most(&format!("{name}: most radiance or light"), largest(&here, |row| row[1]), 3.0);
    }
    let hits = rows.iter().filter(|row| row[2] > 0.5).count() as f64;
    report.at_least("rays that met a tree", hits, 300.0);
    report.finish();
}

#[test]
fn trees_take_light_and_never_give_it() {
    let mut report = Report::new("Trees", "trees_take_light_and_never_give_it");
    let fragment = format!(
        "{RAYS}{}",
        r#"
fn light_left(seed: u32) -> f32 {
    let origin = ray_origin(seed);
    let y = terrain_height_filtered(origin.xz, trees.spacing);
    return trees_shadow(vec3f(origin.x, y, origin.z), 0.05, sky_daylight(origin));
}
"#
    );
    let seeds: Vec<_> = (0..3000).map(|seed| [seed as f32]).collect();
    for (share, name) in [("0", "no trees"), ("1", "closed woods")] {
        let mut preset = woods();
        preset.set(&format!("trees.share={share}")).unwrap();
        preset.set("sun.elevation=20").unwrap();
        let scope = Scope { includes: TREES, fragment: &fragment, preset: Some(&preset) };
        let rows = values("light_left(seed)", &scope, ["seed:u32"], &seeds);
        report.at_least(&format!("{name}: least light on the ground"), -largest(&rows, |row| -row[0]), 0.0);
        report.at_most(&format!("{name}: most light on the ground"), largest(&rows, |row| row[0]), 1.0);
        let mean = rows.iter().map(|row| row[0]).sum::<f64>() / rows.len() as f64;
        if share == "0" {
            report.near("no trees: mean light on the ground", mean, 1.0, 0.0);
        } else {
            report.at_most("closed woods: mean light on the ground", mean, 0.1);
        }
    }
    let scope = Scope { includes: TREES, fragment: "", preset: None };
    report.told("farthest that a tree reaches out of its cell, cells", value("TREE_OVERHANG", &scope)[0]);
    report.finish();
}

#[test]
fn no_tree_stands_where_the_land_was_seen_far_below() {
    let mut report = Report::new("Trees", "no_tree_stands_where_the_land_was_seen_far_below");
    let fragment = r#"
#include <noise/pcg.wgsl>
#include <terrain/height.wgsl>
#include <terrain/shade.wgsl>
#include <trees/trees.wgsl>

// How near the ray comes to the land before it need be asked for trees, in heights of the tallest; how far that is and how
// far the ray goes in all (m).
fn clear_way(seed: u32) -> vec3f {
    let dice = unit_float3(pcg3d(vec3u(seed, 1u, 2u)));
    let aim = unit_float3(pcg3d(vec3u(seed, 3u, 4u)));
    let place = 20000.0 * (dice.xz - 0.5);
    let origin = vec3f(place.x, terrain_height(place) + 2.0 + 250.0 * dice.y * dice.y, place.y);
    let turn = 6.2831853 * aim.x;
    let direction = normalize(vec3f(cos(turn), 0.35 * (aim.y - 0.75), sin(turn)));
    let approach = terrain_approach(origin, direction, 1.0, trees_clearance());
    let far = min(approach.clear, trees_end());
    var least = 1e9;
    for (var i = 1; i <= 400; i++) {
        let p = origin + f32(i) / 401.0 * far * direction;
        least = min(least, p.y - terrain_height_filtered(p.xz, trees.spacing));
    }
    return vec3f(select(1e9, least / trees.tallest, far > 0.0), far, min(approach.hit.distance, trees_end()));
}
"#;
    let seeds: Vec<_> = (0..4000).map(|seed| [seed as f32]).collect();
    for (quality, allowed) in [("high", 0.0), ("low", 0.002)] {
        let mut preset = woods();
        preset.set(&format!("quality={quality}")).unwrap();
        let scope = Scope { includes: TREES, fragment, preset: Some(&preset) };
        let rows = values("clear_way(seed)", &scope, ["seed:u32"], &seeds);
        let low = rows.iter().filter(|row| row[0] < 1.0).count() as f64 / rows.len() as f64;
        report.at_most(&format!("{quality}: part of the rays that come among trees before"), low, allowed);
        let sum = |column: usize| rows.iter().map(|row| row[column]).sum::<f64>();
        report.at_least(&format!("{quality}: part of the way that is left out"), sum(1) / sum(2), 0.25);
    }
    report.finish();
}
