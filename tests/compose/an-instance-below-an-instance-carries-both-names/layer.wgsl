#include <noises.wgsl>
#include <fbm.wgsl> as detail with noise2 = own_noise
#param layer.cover: f32 = 0.5

/// Its own noise.
fn own_noise(p: vec2f) -> f32 { return perlin2(p) * SHARPNESS; }

const SHARPNESS = 2.0;

fn density(p: vec2f) -> f32 {
    return detail_fbm2(p) * layer.cover;
}
