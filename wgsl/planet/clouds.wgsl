// Clouds of a whole planet as they look from orbit: a thin shell, swept into fronts and cyclones.
//
// What they are up close <clouds/layer.wgsl> shows; here one number a place says how thick they are.

#include <fractal/fbm3.wgsl> as shell with noise3 = perlin_noise3_grad
#include <frame.wgsl>
#include <noise/curl.wgsl>
#include <noise/pcg.wgsl>
#include <noise/perlin.wgsl>
#include <sky/medium.wgsl>

/// Part of the sky that clouds cover, near enough.
#param shell.cover: f32 = 0.55, range 0 .. 1
/// Height of the shell above sea level.
#param shell.height: f32 = 6000.0, range 100 .. 50000, unit m
/// Optical thickness of the thickest clouds.
#param shell.thickness: f32 = 30.0, range 0 .. 200
/// Width of the largest fields of clouds, as a part of the planet's radius.
#param shell.scale: f32 = 0.30, range 0.02 .. 2
/// How far the wind has swept them, as a part of that width.
#param shell.sweep: f32 = 0.16, range 0 .. 1
/// How often a cyclone has turned its middle.
#param shell.turns: f32 = 0.8, range 0 .. 3
/// How fast the wind carries them to the east, over the equator; as many degrees an hour at all latitudes.
#param shell.wind_speed: f32 = 15.0, range -200 .. 200, unit m/s
/// How fast they form and dissolve: the speed at which the noise that shapes the fields moves through the shell.
#param shell.evolution: f32 = 4.0, range 0 .. 200, unit m/s
/// Which day.
#param shell.seed: u32 = 1

const SHELL_CYCLONES: u32 = 14u;
const SHELL_FORWARD: f32 = 0.85; // mean cosine of the angle that droplets scatter by
const SHELL_OCTAVES: f32 = 11.5;
const SHELL_FLECKS: f32 = 32.0; // how much smaller the largest flecks are than the largest fields
const SHELL_LARGE: f32 = 5.0; // log2 of that
// Where the noise moves to, and flecks, which live shorter than fields do: across.
const SHELL_COURSE: vec3f = vec3f(0.48, 0.60, -0.64);
const SHELL_FLECKS_COURSE: vec3f = vec3f(-1.2, 0.9, 0.0);

/// How thick the clouds are above the unit `direction` from the planet's centre, in the planet's own axes: 0 clear .. 1. A
/// pixel covers `footprint` (rad) of it. Three noises and up to thirteen octaves.
fn shell_at(direction: vec3f, footprint: f32) -> f32 {
    let eastward = shell.wind_speed / sky.ground_radius * frame.time;
    let carried = turned_about(direction, vec3f(0.0, 1.0, 0.0), -eastward);
    let evolved = shell.evolution / sky.ground_radius * frame.time;
    // Cyclones wind the map up, against the clock on the north, with it on the south.
    var q = carried;
    for (var i = 0u; i < SHELL_CYCLONES; i++) {
        let dice = unit_float3(pcg3d(vec3u(i, shell.seed, 401u)));
        let north = select(-1.0, 1.0, (i & 1u) == 0u);
        let latitude = north * (0.35 + 0.75 * dice.x);
        let longitude = 6.2831853 * dice.y;
        let eye = vec3f(cos(latitude) * cos(longitude), sin(latitude), -cos(latitude) * sin(longitude));
        let size = 0.07 + 0.16 * dice.z * dice.z;
        let off = q - eye;
        let near = dot(off, off) / (size * size);
        if near < 12.0 {
            let angle = -6.2831853 * north * shell.turns * exp(-near);
            q = turned_about(q, eye, angle);
        }
    }
    let place = (q + evolved * SHELL_COURSE) / shell.scale;
    let swept = place + shell.sweep * curl_noise3(0.7 * place, shell.seed + 11u);
    let octaves = min(SHELL_OCTAVES, log2(shell.scale / max(2.0 * footprint, 1e-6)));
    // Longer from west to east than from north to south; what is small has formed since, and is not drawn out.
    let drawn = vec3f(swept.x, 1.5 * swept.y, swept.z);
    let fields = shell_fbm3(drawn, shell.seed + 3u, clamp(octaves, 1.0, 6.0), 0.64, 2.03).x;
    let fine = octaves - SHELL_LARGE;
    let small = (carried + evolved * SHELL_FLECKS_COURSE) * (SHELL_FLECKS / shell.scale) + 0.25 * swept;
    let flecks = shell_fbm3(small, shell.seed + 5u, fine, 0.96, 2.03).x;
    // Wet along the equator and in the westerlies, dry between and at the poles.
    let climate = 0.22 * cos(6.0 * asin(clamp(direction.y, -1.0, 1.0))) - 0.25 * direction.y * direction.y;
    let above = fields + climate - (0.55 - 1.1 * shell.cover);
    // Fronts with torn edges and lanes between their bands; beside them flocks of small heaps; around both thin veils.
    let front = smoothstep(-0.05, 0.75, above + 0.15 * flecks) * (0.72 + 0.35 * fields + 0.36 * flecks);
    let heaps = 0.6 * smoothstep(0.25, 1.25, flecks + 1.7 * above);
    let veil = 0.22 * smoothstep(-0.25, 0.35, above + 0.10 * flecks);
    return clamp(max(max(front, heaps), veil), 0.0, 1.0);
}

/// `v` turned by `angle` (rad) about the unit `axis`, counter-clockwise as seen from its tip.
fn turned_about(v: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let c = cos(angle);
    return c * v + sin(angle) * cross(axis, v) + (1.0 - c) * dot(axis, v) * axis;
}

/// Optical thickness of clouds as thick as `cover`.
fn shell_depth(cover: f32) -> f32 {
    return shell.thickness * cover * cover;
}

/// Part of the light that gets through clouds of optical thickness `depth`, scattered or not: 0 .. 1 (Eddington's two
/// streams, light from all sides); what does not is thrown back.
fn shell_transmittance(depth: f32) -> f32 {
    return 1.0 / (1.0 + 0.75 * (1.0 - SHELL_FORWARD) * depth);
}
