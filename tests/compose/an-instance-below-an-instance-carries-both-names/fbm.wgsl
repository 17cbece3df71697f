// Noise upon noise.

/// The noise it is made of.
#slot noise2: fn(p: vec2f) -> f32

/// How many octaves.
#param fbm.octaves: i32 = 4, range 1 .. 8
/// By what the width shrinks.
const LACUNARITY = 2.0;

fn fbm2(p: vec2f) -> f32 {
    var sum = 0.0;
    var q = p;
    for (var i = 0; i < fbm.octaves; i++) {
        sum += noise2(q);
        q *= LACUNARITY;
    }
    return sum;
}
