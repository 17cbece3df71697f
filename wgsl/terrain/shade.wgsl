// How the land is found by a ray, shadowed and lit.

#include <camera/camera.wgsl>
#include <light/daylight.wgsl>
#include <light/outdoor.wgsl>
#include <march/hit.wgsl>
#include <march/shadow.wgsl> as cast with height = terrain_height_filtered
#include <quality.wgsl>
#include <terrain/height.wgsl>
#include <terrain/material.wgsl>
// A plain sum of octaves is marched without missing anything, unless in haste; other reliefs by steps that tests have shown to
// be safe.
#if quality != low && terrain.relief == fbm && !terrain.eroded && !terrain.distorted && !terrain.rough
#include <march/heightfield_bounded.wgsl> as land with octave = sum_octave, octave_bounds = sum_octave_bounds, ruggedness = sum_ruggedness
#include <terrain/sum.wgsl>
#else
#include <march/heightfield_adaptive.wgsl> as land with height = terrain_height_marched
#endif

/// How far away land is still looked for.
#param terrain.far: f32 = 45000.0, range 100 .. 1000000, log, unit m
/// How far shadows are thrown.
#param terrain.shadow_reach: f32 = 9000.0, range 1 .. 100000, log, unit m
/// Albedo of the surroundings, for the light that they throw back.
#param terrain.surroundings: vec3f = (0.12, 0.12, 0.10), color
/// How wide the hollows are that see less of the sky.
#param terrain.hollow: f32 = 250.0, range 0.1 .. 10000, unit m

#if quality == low
const LAND_STEPS: i32 = 48;
const LAND_HALVINGS: i32 = 3; // of the last step, to find the ground in it
const LAND_RELAX: f32 = 1.0;
const LAND_GROWTH: f32 = 0.035;
const LAND_SHADOW_STEPS: i32 = 3;
const LAND_DETAIL: f32 = 4.0; // width of the smallest detail looked at, in pixels
const LAND_EXACT: f32 = 1.2; // how exactly it is met, in pixels
const LAND_BLUR: f32 = 6.0; // how much coarser than that the land may be while a ray looks for it
const LAND_MIRRORED: f32 = 2.0; // by how much a mirrored ray takes fewer and longer steps
#elif quality == medium
const LAND_STEPS: i32 = 150;
const LAND_HALVINGS: i32 = 8;
const LAND_RELAX: f32 = 0.5;
const LAND_GROWTH: f32 = 0.003;
const LAND_SHADOW_STEPS: i32 = 28;
const LAND_DETAIL: f32 = 1.5;
const LAND_EXACT: f32 = 1.5;
const LAND_BLUR: f32 = 1.0;
const LAND_MIRRORED: f32 = 1.0;
#elif quality == high
const LAND_STEPS: i32 = 320;
const LAND_HALVINGS: i32 = 8;
const LAND_RELAX: f32 = 0.35;
const LAND_GROWTH: f32 = 0.0010;
const LAND_SHADOW_STEPS: i32 = 48;
const LAND_DETAIL: f32 = 1.0;
const LAND_EXACT: f32 = 1.0;
const LAND_BLUR: f32 = 1.0;
const LAND_MIRRORED: f32 = 1.0;
#else
const LAND_STEPS: i32 = 500;
const LAND_HALVINGS: i32 = 8;
const LAND_RELAX: f32 = 0.28;
const LAND_GROWTH: f32 = 0.0005;
const LAND_SHADOW_STEPS: i32 = 96;
const LAND_DETAIL: f32 = 0.7;
const LAND_EXACT: f32 = 0.7;
const LAND_BLUR: f32 = 1.0;
const LAND_MIRRORED: f32 = 1.0;
#endif

/// Height of the land (m) as a march looks at it.
fn terrain_height_marched(p: vec2f, footprint: f32) -> f32 {
    return terrain_height_filtered(p, LAND_BLUR * footprint);
}

/// Where a ray meets the land.
fn terrain_trace(origin: vec3f, direction: vec3f) -> MarchHit {
    return terrain_approach(origin, direction, 1.0, 0.0).hit;
}

/// As `terrain_trace`, in steps `haste` (1 or more) times as long, and as many times fewer; and how far the ray stays
/// `clearance` (m) or more above the land, where the march looks at whole heights.
fn terrain_approach(origin: vec3f, direction: vec3f, haste: f32, clearance: f32) -> MarchApproach {
    let most = i32(f32(LAND_STEPS) / haste);
    let pixel_angle = LAND_EXACT * camera_pixel_angle();
#if quality != low && terrain.relief == fbm && !terrain.eroded && !terrain.distorted && !terrain.rough
    // The wide map's octaves are counted as if the land's own went on toward the coarse.
    let coarsest = terrain.scale * pow(terrain.lacunarity, f32(WIDE_OCTAVES));
    let octaves = terrain.octaves + f32(WIDE_OCTAVES);
    let plain = select(i32(ceil(octaves)), WIDE_OCTAVES, WIDE_OCTAVES > 0);
    let how = land_Bounded(octaves, plain, coarsest, terrain.lacunarity, pixel_angle, 0.01, 4 * most);
    let hit = land_march(origin - vec3f(0.0, sum_base(), 0.0), direction, 0.0, terrain.far, how);
    return MarchApproach(hit, 0.0);
#else
    let how = land_Adaptive(0.05, haste * LAND_GROWTH, haste * LAND_RELAX, most, LAND_HALVINGS, pixel_angle);
    return land_approach(origin, direction, terrain_ceiling(), terrain.far, clearance, how);
#endif
}

/// Part of the sun that the land leaves to `position` (m), 0 .. 1; `normal` is the land's there.
fn terrain_shadow(position: vec3f, normal: vec3f, footprint: f32, day: Daylight) -> f32 {
    if dot(normal, day.to_sun) <= 0.0 {
        return 0.0;
    }
    let start = position + max(0.5 * footprint, 0.02) * normal;
    return cast_shadow_soft(
        start, day.to_sun, day.radius, max(2.0 * footprint, 0.3), terrain.shadow_reach, terrain_ceiling(), footprint,
        LAND_SHADOW_STEPS,
    );
}

/// Radiance of the ground at `position` (m) with unit `normal` in the light of `day`, of whose sun `sun_seen` is seen,
/// 0 .. 1; no haze.
fn terrain_shade(position: vec3f, normal: vec3f, footprint: f32, day: Daylight, sun_seen: f32) -> vec3f {
    let here = terrain_material(position, normal, footprint);
    // A hollow is where the land around is higher than here: it sees less of the sky.
    let around = terrain_height_filtered(position.xz, terrain.hollow);
    let openness = clamp(0.85 + 1.2 * (position.y - around) / terrain.hollow, 0.35, 1.0);
    return outdoor_radiance(
        here.albedo, here.normal, day.to_sun, day.sun, day.sky, sun_seen, openness, terrain.surroundings,
    );
}

/// Width (m) of a pixel `distance` (m) away, as far as the land's details are concerned.
fn terrain_footprint(distance: f32) -> f32 {
    return LAND_DETAIL * distance * camera_pixel_angle();
}
