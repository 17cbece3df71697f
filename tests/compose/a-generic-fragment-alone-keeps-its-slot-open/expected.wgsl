// ---- fbm ----
/// How many octaves.
const fbm_octaves: i32 = 4;
fn noise2(a0: vec2f) -> f32 { return f32(); }
fn tell(a0: f32) {}

// ---- input.wgsl ----
// Noise upon noise.

/// By what the width shrinks.
const LACUNARITY = 2.0;

fn fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < fbm_octaves; i++) {
        sum += noise2(q);
        q *= LACUNARITY;
    }
    return sum;
}

fn talk() { tell(fbm2(vec2f())); }
