// Bands of material from the valley up: mud, sand, grass, rock, snow, with ragged boundaries.

#include <fractal/fbm.wgsl> as patches with noise2 = perlin_noise2_grad
#include <noise/perlin.wgsl>
#include <noise/value.wgsl>
#include <terrain/material.wgsl>
#include <trees/cover.wgsl>
#include <water/level.wgsl>

/// Height above `water.level` below which the ground is mud.
#param ground.mud_line: f32 = -100.0, range -1000 .. 9000, unit m
/// Height above `water.level` below which, above the mud, the ground is sand.
#param ground.sand_line: f32 = -60.0, range -1000 .. 9000, unit m
/// Height above which no grass grows.
#param ground.grass_line: f32 = 1100.0, range -1000 .. 9000, unit m
/// Height above which snow lies where it can.
#param ground.snow_line: f32 = 1500.0, range -1000 .. 12000, unit m
/// How far the boundaries wander up and down.
#param ground.raggedness: f32 = 160.0, range 0 .. 2000, unit m
/// Steepest slope that grass holds to.
#param ground.grass_slope: f32 = 36.0, range 0 .. 90, unit deg
/// Steepest slope that snow lies on.
#param ground.snow_slope: f32 = 44.0, range 0 .. 90, unit deg
/// Albedo of wet mud.
#param ground.mud: vec3f = (0.09, 0.07, 0.05), color
/// Albedo of sand and gravel.
#param ground.gravel: vec3f = (0.30, 0.26, 0.20), color
/// Albedo of fresh grass.
#param ground.grass: vec3f = (0.055, 0.085, 0.022), color
/// Albedo of dry grass.
#param ground.dry_grass: vec3f = (0.16, 0.135, 0.06), color
/// Albedo of rock.
#param ground.rock: vec3f = (0.27, 0.245, 0.22), color
/// Albedo of the darker stripes in it.
#param ground.dark_rock: vec3f = (0.11, 0.10, 0.095), color
/// Albedo of snow.
#param ground.snow: vec3f = (0.82, 0.84, 0.87), color
/// Thickness of the stripes in the rock.
#param ground.stripes: f32 = 45.0, range 0.1 .. 1000, unit m

/// Rock with stripes: noise much wider than high, strongest on steep faces.
fn striped_rock(position: vec3f, normal: vec3f, wander: f32) -> vec3f {
    let bed = vec3f(position.x / 14.0, position.y + 0.10 * position.x + 40.0 * wander, position.z / 14.0);
    let thick = value_noise3(bed / ground.stripes, 41u);
    let thin = value_noise3(bed / (0.31 * ground.stripes) + vec3f(17.3), 43u);
    let stripe = smoothstep(-0.28, 0.28, 0.6 * thick + 0.4 * thin);
    let steep = 1.0 - smoothstep(0.55, 0.9, normal.y);
    return mix(ground.rock, ground.dark_rock, stripe * (0.35 + 0.65 * steep));
}

/// The ground in bands. Six fBms and two noises.
fn bands_surface(position: vec3f, normal: vec3f, footprint: f32) -> Surface {
    let octaves = clamp(log2(400.0 / max(2.0 * footprint, 0.05)), 0.0, 9.0);
    let wander = patches_fbm2(position.xz / 400.0, 5u, octaves, 0.55, 2.03).x;
    let mottle = patches_fbm2(position.xz / 37.0, 6u, octaves - 3.0, 0.6, 2.03).x;
    let y = position.y + ground.raggedness * wander;

    var albedo = striped_rock(position, normal, wander) * (1.0 + 0.4 * mottle);

    let dryness = smoothstep(-0.5, 0.7, wander + 0.9 * mottle + 0.9 * (y / max(ground.grass_line, 1.0) - 0.35));
    let turf = mix(ground.grass, ground.dry_grass, dryness) * (1.0 + 0.35 * mottle);
    let holds = smoothstep(cos(ground.grass_slope + 0.14), cos(ground.grass_slope - 0.14), normal.y + 0.06 * mottle);
    let thin = smoothstep(-1.0, 1.0, (y - ground.grass_line) / max(ground.raggedness, 1.0));
    let grown = holds * (1.0 - smoothstep(0.38, 0.62, thin + 0.25 * mottle));
    albedo = mix(albedo, turf, grown);

    // Woods as they look from afar: dark, closed, the crowns catching the light. Near ones have trees of their own.
    let crown_octaves = clamp(log2(11.0 / max(2.0 * footprint, 0.05)), 0.0, 3.0);
    let crowns = patches_fbm2(position.xz / 11.0, 9u, crown_octaves, 0.6, 2.1);
    let wooded = trees_cover(position, normal);
    albedo = mix(albedo, trees_canopy_albedo(position.xz) * (1.0 + 0.6 * crowns.x), wooded);

    let shore = max(0.1 * ground.raggedness, 0.5);
    let beach = ground.gravel * (1.0 + 0.3 * mottle);
    let dry = y - water.level;
    albedo = mix(albedo, beach, 1.0 - smoothstep(-shore, shore, dry - ground.sand_line));
    albedo = mix(albedo, ground.mud, 1.0 - smoothstep(-shore, shore, dry - ground.mud_line));

    // Snow: above its line, more and more of it higher up, on what is not too steep; drifts in the hollows of
    // the noise.
    let above = (y - ground.snow_line) / max(ground.raggedness, 1.0);
    let limit = ground.snow_slope + 0.12 * clamp(above * 0.4, -1.0, 1.5) + 0.10 * mottle;
    let lies = smoothstep(cos(limit + 0.10), cos(limit - 0.08), normal.y);
    let patchy = smoothstep(0.38, 0.62, smoothstep(-1.0, 1.2, above) + 0.30 * mottle); // melts in patches
    let snow_cover = patchy * lies;
    albedo = mix(albedo, ground.snow, snow_cover);

    // Stones and tussocks, too small for the height; snow lies smoothly.
    let grain_octaves = clamp(log2(3.1 / max(2.0 * footprint, 0.01)), 0.0, 5.0);
    let grain = patches_fbm2(position.xz / 3.1, 8u, grain_octaves, 0.6, 2.1);
    let rough = 0.22 * (1.0 - snow_cover);
    let bend = 0.35 * rough * grain.yz + 0.45 * wooded * crowns.yz;
    let bent = normalize(normal - vec3f(bend.x, 0.0, bend.y));
    return Surface(clamp(albedo, vec3f(0.0), vec3f(0.95)), bent);
}
