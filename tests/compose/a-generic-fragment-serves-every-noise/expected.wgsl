// ---- detail ----
/// How many octaves.
const detail_octaves: i32 = 2;
struct OrogenParams {
    /// How many octaves.
    relief_octaves: i32,
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- noises.wgsl ----
fn value2(p: vec2f) -> f32 { return p.x; }
fn perlin2(p: vec2<f32>) -> f32 { return p.y; }

// ---- fbm.wgsl as relief ----
// Noise upon noise.

/// By what the width shrinks.
const relief_LACUNARITY = 2.0;

fn relief_fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < orogen.relief_octaves; i++) {
        sum += perlin2(q);
        q *= relief_LACUNARITY;
    }
    return sum;
}

// ---- fbm.wgsl as detail ----
// Noise upon noise.

/// By what the width shrinks.
const detail_LACUNARITY = 2.0;

fn detail_fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < detail_octaves; i++) {
        sum += value2(q);
        q *= detail_LACUNARITY;
    }
    return sum;
}

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(relief_fbm2(vec2f(1)) + detail_fbm2(vec2f(2)) + f32(orogen.relief_octaves));
}
