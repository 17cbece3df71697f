// A plateau cut by canyons: hard layers stand as cliffs, soft ones lie as slopes between them.

#include <fractal/fbm.wgsl> as plateau with noise2 = terrain_noise
#include <noise/pcg.wgsl>
#include <terrain/basis.wgsl>
#include <terrain/height.wgsl>

/// Depth of the canyons.
#param terraces.depth: f32 = 900.0, range 1 .. 5000, unit m
/// Layers of rock between the canyon's floor and the plateau.
#param terraces.layers: f32 = 9.0, range 1 .. 60
/// How much of the height is cliff: 0 even slopes, 1 stairs.
#param terraces.cliffs: f32 = 0.85, range 0 .. 1
/// How much of the land is cut away: -1 little, 1 nearly all, so that only mesas are left.
#param terraces.erosion: f32 = 0.2, range -1 .. 1

/// Where one layer of rock ends and the next begins, in mean layers; the first at 0, the last at `layers`.
fn terrace_boundary(index: f32, layers: f32, seed: u32) -> f32 {
    if index <= 0.0 || index >= layers {
        return clamp(index, 0.0, layers);
    }
    return index + 0.8 * unit_float(pcg_cell2(vec2i(i32(index), 0), seed)) - 0.4;
}

/// Stairs of uneven height and how steep they are: (0 .. 1, d/d`level`) for `level` 0 .. 1, never falling. Each has a
/// slope of rubble, a cliff and a bench.
fn terrace_profile(level: f32, layers: f32, cliffs: f32, seed: u32) -> vec2f {
    let x = clamp(level, 0.0, 1.0) * layers;
    var layer = floor(x);
    if x < terrace_boundary(layer, layers, seed) {
        layer -= 1.0;
    } else if x >= terrace_boundary(layer + 1.0, layers, seed) {
        layer += 1.0;
    }
    let base = terrace_boundary(layer, layers, seed);
    let top = max(terrace_boundary(layer + 1.0, layers, seed), base + 1e-3);
    let t = clamp((x - base) / (top - base), 0.0, 1.0);
    let hardness = unit_float(pcg_cell2(vec2i(i32(layer), 1), seed));
    let cliff_height = 0.35 + 0.35 * hardness;
    let r = min(t / 0.45, 1.0);
    let rubble = (0.92 - cliff_height) * r * r * (3.0 - 2.0 * r) * (0.5 + 0.5 * r);
    let c = clamp((t - 0.45) / 0.1, 0.0, 1.0);
    let cliff = cliff_height * c * c * (3.0 - 2.0 * c);
    let bench = 0.08 * t;

    let rubble_slope = select((0.92 - cliff_height) * r * (3.0 + 1.5 * r - 4.0 * r * r) / 0.45, 0.0, t >= 0.45);
    let steepness = rubble_slope + cliff_height * 60.0 * c * (1.0 - c) + 0.08;
    let inside = level > 0.0 && level < 1.0;
    return vec2f(
        (base + (top - base) * mix(t, rubble + cliff + bench, cliffs)) / layers,
        select(0.0, mix(1.0, steepness, cliffs), inside),
    );
}

/// Height of the terraced land (m) and its slope at `p` (m).
fn terraces_height_grad(p: vec2f, octaves: f32) -> vec3f {
    let q = p / terrain.scale;
    let east = terrain_noise(1.7 * q + vec2f(5.2, 1.3), terrain.seed + 61u);
    let south = terrain_noise(1.7 * q + vec2f(8.1, 7.4), terrain.seed + 62u);
    let bent = q + 0.22 * vec2f(east.x, south.x);
    let wide = plateau_fbm2(bent, terrain.seed, min(octaves, 4.0), 0.5, 2.1);
    let wide_slope = wide.yz + 0.374 * (wide.y * east.yz + wide.z * south.yz); // 0.374 = 0.22 · 1.7
    let fine = plateau_fbm2(16.0 * q, terrain.seed + 71u, octaves - 4.0, 0.55, 2.05);
    let level = 0.55 - 0.4 * terraces.erosion + 0.95 * wide.x + 0.035 * fine.x;
    let level_slope = 0.95 * wide_slope + 0.56 * fine.yz; // 0.56 = 0.035 · 16
    let stairs = terrace_profile(level, terraces.layers, terraces.cliffs, terrain.seed + 5u);
    let slope = terraces.depth / terrain.scale * (stairs.y * level_slope + 0.192 * fine.yz);
    return vec3f(terraces.depth * (stairs.x + 0.012 * fine.x), slope);
}

/// A height (m) that the land nowhere exceeds.
fn terraces_ceiling() -> f32 {
    return terraces.depth * 1.03;
}

/// A height (m) that the land nowhere falls below.
fn terraces_floor() -> f32 {
    return terraces.depth * -0.03;
}
