// Layered rock: beds of reds and ochres one over the other, streaked where water runs down the cliffs.

#include <fractal/fbm.wgsl> as weathering with noise2 = perlin_noise2_grad
#include <noise/perlin.wgsl>
#include <noise/value.wgsl>
#include <terrain/material.wgsl>

/// Albedo of the red beds.
#param ground.red_bed: vec3f = (0.36, 0.15, 0.075), color
/// Albedo of the ochre beds.
#param ground.ochre_bed: vec3f = (0.46, 0.28, 0.14), color
/// Albedo of the pale beds.
#param ground.pale_bed: vec3f = (0.52, 0.42, 0.30), color
/// Albedo of the dark coat that grows on old cliffs.
#param ground.varnish: vec3f = (0.12, 0.06, 0.04), color
/// Albedo of rubble and dust on gentle slopes.
#param ground.rubble: vec3f = (0.36, 0.22, 0.13), color
/// Albedo of the scrub that grows on flat ground.
#param ground.scrub: vec3f = (0.09, 0.09, 0.045), color
/// How much of the flat ground is scrub.
#param ground.scrub_cover: f32 = 0.45, range 0 .. 1
/// Thickness of a bed.
#param ground.bed: f32 = 45.0, range 0.1 .. 1000, unit m
/// How sharply one bed's colour ends where the next one's begins: 0 they run into each other, 1 a clean edge.
#param ground.bed_edge: f32 = 0.0, range 0 .. 1
/// How rough the ground is with stones too small for the land's height: their slope, rise over run.
#param ground.grit: f32 = 0.09, range 0 .. 1
/// Slope under which rubble and dust cover the beds.
#param ground.rubble_slope: f32 = 42.0, range 0 .. 90, unit deg

/// Colour of the beds at a height (m) over their own base.
fn bed_color(height: f32, thinnest: f32) -> vec3f {
    let thick = value_noise2(vec2f(height / (2.6 * ground.bed), 3.5), 61u);
    let middle = value_noise2(vec2f(height / ground.bed, 7.5), 63u);
    let fade = 1.0 - smoothstep(0.15, 0.6, thinnest / (0.22 * ground.bed));
    let thin = fade * value_noise2(vec2f(height / (0.22 * ground.bed), 11.5), 67u);
    let soft = max(1.0 - 0.9 * ground.bed_edge, min(thinnest / ground.bed, 1.0)); // no edge finer than can be seen
    let ochre = smoothstep(0.025 - 0.375 * soft, 0.025 + 0.375 * soft, thick + 0.35 * middle);
    let pale = smoothstep(0.375 - 0.175 * soft, 0.375 + 0.175 * soft, middle + 0.3 * thin);
    var color = mix(ground.red_bed, ground.ochre_bed, ochre);
    color = mix(color, ground.pale_bed, pale);
    return color * (1.0 + 0.22 * thin);
}

/// The rock. Three fBms and four noises.
fn strata_surface(position: vec3f, normal: vec3f, footprint: f32) -> Surface {
    let octaves = clamp(log2(500.0 / max(2.0 * footprint, 0.05)), 0.0, 10.0);
    let wander = weathering_fbm2(position.xz / 500.0, 71u, octaves, 0.5, 2.03);
    let mottle = weathering_fbm2(position.xz / 23.0, 73u, octaves - 4.0, 0.6, 2.1).x;
    let beds = position.y + 6.0 * wander.x;
    var albedo = bed_color(beds, footprint);

    // Streaks: noise stretched downward, on cliffs only.
    let cliff = 1.0 - smoothstep(0.4, 0.75, normal.y);
    let streak_fade = 1.0 - smoothstep(0.2, 0.7, footprint / 9.0);
    let streak = value_noise3(vec3f(position.x / 9.0, position.y / 130.0, position.z / 9.0), 77u);
    let coat = cliff * streak_fade * smoothstep(0.0, 0.8, streak + 0.5 * wander.x);
    albedo = mix(albedo, ground.varnish, 0.65 * coat);

    let bare = cos(1.2 * ground.rubble_slope);
    let heaped = cos(0.73 * ground.rubble_slope) + 1e-4;
    let loose = smoothstep(bare, heaped, normal.y + 0.35 * (heaped - bare) * mottle);
    let level = smoothstep(0.90, 0.97, normal.y);
    albedo = mix(albedo, mix(ground.rubble, albedo, 0.45 - 0.35 * level), loose); // of the beds under it, a tinge
    let thicket = 0.5 + 0.9 * mottle + 0.3 * wander.x + ground.scrub_cover;
    let bushes = level * smoothstep(0.0, 0.1, ground.scrub_cover) * smoothstep(0.75, 1.05, thicket);
    albedo = mix(albedo, ground.scrub, 0.85 * bushes);
    albedo *= 1.0 + 0.18 * mottle;

    let fine = clamp(log2(4.0 / max(2.0 * footprint, 0.01)), 0.0, 5.0);
    let grain = weathering_fbm2(position.xz / 4.0, 79u, fine, 0.6, 2.1);
    let bent = normalize(normal - ground.grit * vec3f(grain.y, 0.0, grain.z));
    return Surface(clamp(albedo, vec3f(0.0), vec3f(0.95)), bent);
}
