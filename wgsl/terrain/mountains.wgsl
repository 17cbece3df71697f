// Relief made of noise: rolling, ridged or worn; from one map or two; bent, cut by water, and rough where it is steep.
//
// What steers the water and the roughness is a smoother land of the same forms: fewer octaves, known with its second
// derivatives. So the slope of the whole is analytic, and gullies do not tear where a sharp crest turns about.

#include <fractal/fbm.wgsl> as relief with noise2 = terrain_noise
#include <fractal/jets.wgsl> as smooth with noise2 = terrain_noise_jet
#include <math/jet.wgsl>
#include <quality.wgsl>
#include <terrain/basis.wgsl>
#include <terrain/height.wgsl>
#if terrain.relief == ridged
#include <fractal/ridged.wgsl> as ranges with noise2 = terrain_noise
#elif terrain.relief == hybrid
#include <fractal/hybrid.wgsl> as worn with noise2 = terrain_noise
#elif terrain.relief == billow
#include <fractal/billow.wgsl> as mounds with noise2 = terrain_noise
#elif terrain.relief == damped
#include <fractal/damped.wgsl> as valleys with noise2 = terrain_noise_jet
#endif
#if terrain.eroded
#include <fractal/erosion.wgsl>
#endif

/// Whether a second, wider map says where the land is rugged: plains and ranges instead of the same land everywhere.
#option terrain.dual = false
/// Whether the map is bent before it is read: folded, flowing forms.
#option terrain.distorted = false
/// Whether water has cut gullies into the slopes.
#option terrain.eroded = true
/// Whether the octaves past `terrain.forms` are roughness, weak on level ground; otherwise they are octaves as the
/// first are.
#option terrain.rough = true

/// Height of the highest peaks above the valley floors.
#param terrain.peak_height: f32 = 2400.0, range 0 .. 9000, unit m
/// How many times stronger an octave is than the next finer one is 1 / gain: the land's roughness.
#param terrain.gain: f32 = 0.45, range 0.1 .. 0.9
/// How many times finer an octave is than the one before.
#param terrain.lacunarity: f32 = 2.02, range 1.5 .. 3
/// How sharp the ridges are: 0 a knife's edge, 0.3 worn hills.
#param terrain.roundness: f32 = 0.08, range 0 .. 1
/// Octaves that make the forms, where the finer ones are roughness.
#param terrain.forms: f32 = 4.0, range 1 .. 14

/// Width of the forms of the wide map.
#param terrain.region: f32 = 20000.0, range 10 .. 1000000, log, unit m
/// How much higher the rugged regions lie than the plains.
#param terrain.uplift: f32 = 300.0, range 0 .. 9000, unit m
/// How much of the land is plain: -1 none, 1 nearly all.
#param terrain.valleys: f32 = 0.0, range -1 .. 1
/// How much of the relief is left on the plains.
#param terrain.lowland: f32 = 0.08, range 0 .. 1

/// How far the map is bent, as a part of the width of its largest forms.
#param terrain.distortion: f32 = 0.25, range 0 .. 2

/// How deep water has cut into the slopes.
#param terrain.gully_depth: f32 = 220.0, range 0 .. 2000, unit m
/// How wide the widest gullies are.
#param terrain.gully_width: f32 = 900.0, range 10 .. 20000, unit m

/// Height of the roughness: boulders, humps and hollows.
#param terrain.detail: f32 = 110.0, range 0 .. 500, unit m

// The two octaves of the wide map.
const WIDE_PLACE: vec2f = vec2f(3.7, 9.2);
const WIDE_SEED: u32 = 101u;
const WIDE_GAIN: f32 = 0.4;
const WIDE_LACUNARITY: f32 = 2.0;

// Generations of gullies.
#if quality == low
const GULLIES: f32 = 2.0;
#else
const GULLIES: f32 = 5.0;
#endif

/// Forms of the relief at `q` (in widths of the largest ones): (0 .. about 1, slope per width).
fn mountains_forms(q: vec2f, octaves: f32) -> vec3f {
#if terrain.relief == ridged
    return ranges_ridged2(q, terrain.seed, octaves, terrain.gain, terrain.lacunarity, 2.0, terrain.roundness);
#elif terrain.relief == hybrid
    return 0.4 * worn_hybrid2(q, terrain.seed, octaves, terrain.gain, terrain.lacunarity, 0.7);
#elif terrain.relief == billow
    return mounds_billow2(q, terrain.seed, octaves, terrain.gain, terrain.lacunarity, terrain.roundness);
#elif terrain.relief == damped
    let noise = valleys_damped2(q, terrain.seed, octaves, terrain.gain, terrain.lacunarity, 0.25);
    return vec3f(0.5 + 0.5 * noise.x, 0.5 * noise.yz);
#else
    let noise = relief_fbm2(q, terrain.seed, octaves, terrain.gain, terrain.lacunarity);
    return vec3f(0.5 + 0.5 * noise.x, 0.5 * noise.yz);
#endif
}

/// What water and roughness take the forms for: their first octaves, well rounded.
fn mountains_guide(q: vec2f) -> Jet2 {
#if terrain.relief == ridged
    return smooth_ridged2_jet(q, terrain.seed, 3.0, terrain.gain, terrain.lacunarity, 2.0, 0.25);
#else
    let noise = smooth_fbm2_jet(q, terrain.seed, 3.0, terrain.gain, terrain.lacunarity);
    return jet2_sum(jet2_constant(0.5), jet2_scaled(noise, 0.5));
#endif
}

/// The land before water and roughness.
struct Lie {
    /// Height (m) and slope.
    land: vec3f,
    /// The smoother land that steers the water and the roughness (m).
    smoothed: Jet2,
    /// The part of the height that is the wide map's (m); 0 without one.
    wide: f32,
}

/// The lie of the land at `p` (m): its first `octaves` octaves, which may be fractional.
fn mountains_lie(p: vec2f, octaves: f32) -> Lie {
    var q = p / terrain.scale;
#if terrain.distorted
    let bend = terrain.distortion;
    let to_east = smooth_fbm2_jet(q + vec2f(5.2, 1.3), terrain.seed + 401u, 3.0, 0.5, 2.0);
    let to_south = smooth_fbm2_jet(q + vec2f(8.1, 7.4), terrain.seed + 409u, 3.0, 0.5, 2.0);
    let east = jet2_sum(Jet2(q.x, vec2f(1.0, 0.0), vec3f(0.0)), jet2_scaled(to_east, bend));
    let south = jet2_sum(Jet2(q.y, vec2f(0.0, 1.0), vec3f(0.0)), jet2_scaled(to_south, bend));
    q = vec2f(east.value, south.value);
#endif
#if terrain.rough
    let form_octaves = min(octaves, terrain.forms);
#else
    let form_octaves = octaves;
#endif
    var forms = mountains_forms(q, form_octaves);
    var lie = mountains_guide(q);
#if terrain.distorted
    forms = vec3f(forms.x, forms.y * east.gradient + forms.z * south.gradient);
    lie = jet2_composed(lie, east, south);
#endif

    // From here on in metres.
    let per_metre = 1.0 / terrain.scale;
    forms = terrain.peak_height * vec3f(forms.x, per_metre * forms.yz);
    lie = jet2_scaled(jet2_per(lie, per_metre), terrain.peak_height);
    var land = forms;
    var wide_height = 0.0;
#if terrain.dual
    let wide = mountains_wide(p);
    let middle = 0.5 * terrain.valleys;
    let rugged = jet2_smoothstep(middle - 0.45, middle + 0.5, wide);
    let share = jet2_sum(jet2_constant(terrain.lowland), jet2_scaled(rugged, 1.0 - terrain.lowland));
    let swell = jet2_sum(jet2_constant(0.5 * terrain.uplift), jet2_scaled(wide, 0.5 * terrain.uplift));
    land = vec3f(share.value * land.x, share.value * land.yz + land.x * share.gradient)
        + vec3f(swell.value, swell.gradient);
    lie = jet2_sum(jet2_product(share, lie), swell);
    wide_height = swell.value;
#endif
    return Lie(land, lie, wide_height);
}

/// The land (m) and its slope at `p` (m) of the first `octaves` octaves, which may be fractional; for 0 and less only
/// the lie of the land.
///
/// Costly: up to `terrain.octaves` + 8 noises and five generations of gullies.
fn mountains_height_grad(p: vec2f, octaves: f32) -> vec3f {
    let base = mountains_lie(p, octaves);
    var land = base.land;
    let lie = base.smoothed;
#if terrain.eroded
    land += mountains_erosion(p, lie, octaves);
#endif
#if terrain.rough
    // Most where it is steep: by the square of the slope, which has no kink on level ground.
    let g = lie.gradient;
    let steep = clamp(dot(g, g), 0.0, 1.0);
    let steepening = 2.0 * vec2f(dot(lie.hessian.xy, g), dot(lie.hessian.yz, g));
    let weight = 0.08 + 0.92 * steep * (2.0 - steep);
    let weight_slope = 1.84 * (1.0 - steep) * steepening;
    let finer = exp2(terrain.forms) / terrain.scale;
    let fine = relief_fbm2(finer * p, terrain.seed + 307u, octaves - terrain.forms, 0.58, terrain.lacunarity);
    land += terrain.detail * vec3f(weight * fine.x, weight * finer * fine.yz + fine.x * weight_slope);
#endif
    return land;
}

#if terrain.dual
/// The wide map: where the land is high and rugged and where it is plain, about -1 .. 1.
fn mountains_wide(p: vec2f) -> Jet2 {
    let place = p / terrain.region + WIDE_PLACE;
    let wide = smooth_fbm2_jet(place, terrain.seed + WIDE_SEED, 2.0, WIDE_GAIN, WIDE_LACUNARITY);
    return jet2_per(wide, 1.0 / terrain.region);
}
#endif

#if terrain.eroded
/// What water has done to the land `lie` at `p`: (change in m, slope).
fn mountains_erosion(p: vec2f, lie: Jet2, octaves: f32) -> vec3f {
    let generations = min(GULLIES, octaves - log2(terrain.scale / terrain.gully_width) + 1.0);
    let how = Erosion(
        terrain.gully_width,
        0.5 * terrain.gully_depth,
        generations,
        0.5, // gain
        2.0, // lacunarity
        1.5 * terrain.gully_depth / terrain.gully_width, // the slope that steers
        0.25, // half as deep on such a slope
        0.12, // crests
        0.25, // bottoms
        -0.1 * terrain.peak_height,
        1.1 * terrain.peak_height,
    );
    return erosion2(p, lie, how, terrain.seed + 211u);
}
#endif

/// The lowest and the highest height (m) that the mountains can have.
fn mountains_bounds() -> vec2f {
#if terrain.rough
    let octaves = terrain.forms;
    let rough = terrain.detail * relief_fbm_bound(16.0, 0.58);
#else
    let octaves = terrain.octaves;
    let rough = 0.0;
#endif
#if terrain.relief == ridged
    let forms = ranges_ridged_bound(octaves, terrain.gain);
#elif terrain.relief == hybrid
    let forms = 0.4 * worn_hybrid_bound(octaves, terrain.gain, 0.7);
#elif terrain.relief == billow
    let forms = mounds_billow_bound(octaves, terrain.gain);
#else
    let forms = vec2f(0.5) + vec2f(-0.5, 0.5) * relief_fbm_bound(octaves, terrain.gain);
#endif
    // On the plains of a wide map less is left of the forms, down to nothing.
    var bounds = vec2f(min(terrain.peak_height * forms.x, 0.0) - rough, terrain.peak_height * forms.y + rough);
#if terrain.dual
    bounds += vec2f(-0.2, 1.2) * terrain.uplift;
#endif
#if terrain.eroded
    bounds += vec2f(-0.5, 0.5) * terrain.gully_depth;
#endif
    return bounds;
}

/// A height (m) that the mountains nowhere exceed.
fn mountains_ceiling() -> f32 {
    return mountains_bounds().y;
}
