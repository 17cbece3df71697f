// ---- high_base ----
/// How many octaves.
const high_base_octaves: i32 = 4;
// ---- high_twice ----
/// How many octaves.
const high_twice_octaves: i32 = 4;

// ---- noises.wgsl ----
fn perlin2(p: vec2<f32>) -> f32 { return p.y; }

// ---- fbm.wgsl as high_base ----
// Noise upon noise.

/// By what the width shrinks.
const high_base_LACUNARITY = 2.0;

fn high_base_fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < high_base_octaves; i++) {
        sum += perlin2(q);
        q *= high_base_LACUNARITY;
    }
    return sum;
}

// ---- fbm.wgsl as high_twice ----
// Noise upon noise.

/// By what the width shrinks.
const high_twice_LACUNARITY = 2.0;

fn high_twice_fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < high_twice_octaves; i++) {
        sum += high_doubled(q);
        q *= high_twice_LACUNARITY;
    }
    return sum;
}

// ---- ridges.wgsl as high ----
fn high_doubled(p: vec2f) -> f32 { return 2.0 * perlin2(p); }

fn high_ridges(p: vec2f) -> f32 { return 1.0 - abs(high_base_fbm2(p)) - high_twice_fbm2(p); }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(high_ridges(vec2f(1)));
}
