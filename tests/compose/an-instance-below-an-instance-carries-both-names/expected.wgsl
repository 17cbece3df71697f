// ---- cirrus ----
const cirrus_cover: f32 = 0.5;
// ---- cirrus_detail ----
/// How many octaves.
const cirrus_detail_octaves: i32 = 2;
// ---- cumulus ----
const cumulus_cover: f32 = 0.25;
// ---- cumulus_detail ----
/// How many octaves.
const cumulus_detail_octaves: i32 = 4;

// ---- noises.wgsl ----
fn perlin2(p: vec2<f32>) -> f32 { return p.y; }

// ---- fbm.wgsl as cirrus_detail ----
// Noise upon noise.

/// By what the width shrinks.
const cirrus_detail_LACUNARITY = 2.0;

fn cirrus_detail_fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < cirrus_detail_octaves; i++) {
        sum += cirrus_own_noise(q);
        q *= cirrus_detail_LACUNARITY;
    }
    return sum;
}

// ---- layer.wgsl as cirrus ----
/// Its own noise.
fn cirrus_own_noise(p: vec2f) -> f32 { return perlin2(p) * cirrus_SHARPNESS; }

const cirrus_SHARPNESS = 2.0;

fn cirrus_density(p: vec2f) -> f32 {
    return cirrus_detail_fbm2(p) * cirrus_cover;
}

// ---- fbm.wgsl as cumulus_detail ----
// Noise upon noise.

/// By what the width shrinks.
const cumulus_detail_LACUNARITY = 2.0;

fn cumulus_detail_fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < cumulus_detail_octaves; i++) {
        sum += cumulus_own_noise(q);
        q *= cumulus_detail_LACUNARITY;
    }
    return sum;
}

// ---- layer.wgsl as cumulus ----
/// Its own noise.
fn cumulus_own_noise(p: vec2f) -> f32 { return perlin2(p) * cumulus_SHARPNESS; }

const cumulus_SHARPNESS = 2.0;

fn cumulus_density(p: vec2f) -> f32 {
    return cumulus_detail_fbm2(p) * cumulus_cover;
}

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(cirrus_density(vec2f(1)) + cumulus_density(vec2f(2)));
}
