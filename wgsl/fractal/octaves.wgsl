// What the fractals of this folder share: how their octaves lie to one another, and sums over them.

/// No fractal adds up more octaves than these.
const FRACTAL_MAX_OCTAVES: i32 = 16;
/// Each octave is turned by 36.87 degrees (exact in a 3-4-5 triangle) and shifted, so that no two lattices line up.
const FRACTAL_TURN: mat2x2f = mat2x2f(vec2f(0.8, 0.6), vec2f(-0.6, 0.8));
/// How far an octave is shifted against the one before, in its own cells. Shifts do not pass through the lacunarity: near
/// the origin places stay small numbers, which f32 knows well.
const FRACTAL_SHIFT: vec2f = vec2f(37.31, 17.83);
/// As `FRACTAL_SHIFT`, of ridged multifractals.
const FRACTAL_RIDGE_SHIFT: vec2f = vec2f(-21.67, 43.19);

// Mean of (1 - |n|)² for gradient noise. Later octaves of ridges are centred on it, so that leaving one out does not
// sink the land.
const FRACTAL_MEAN_RIDGE: f32 = 0.606;

/// 1 + ratio + ratio² + …, one term an octave, the last in part: `octaves` may be fractional, 0 .. 16.
fn octave_sum(octaves: f32, ratio: f32) -> f32 {
    var sum = 0.0;
    var term = 1.0;
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        sum += term * presence;
        term *= ratio;
    }
    return sum;
}

/// The gain that gives fBm the Hurst exponent `hurst` (0 rough .. 1 smooth) at `lacunarity` > 1: lacunarity^-hurst.
///
/// The power spectrum of such a surface falls as frequency^-(2 hurst + 2) (Musgrave, in Ebert et al., "Texturing and
/// Modeling").
fn fbm_gain(hurst: f32, lacunarity: f32) -> f32 {
    return pow(lacunarity, -hurst);
}
