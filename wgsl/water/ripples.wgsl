// Waves as noise: octaves of ripples that run with the wind, each at its own speed; and lanes of breeze and calm.

#include <frame.wgsl>
#include <math/rotation.wgsl>
#include <noise/perlin.wgsl>
#include <quality.wgsl>
#include <water/wind.wgsl>

#if quality == low
const RIPPLE_OCTAVES: i32 = 4;
#elif quality == medium
const RIPPLE_OCTAVES: i32 = 5;
#else
const RIPPLE_OCTAVES: i32 = 7;
#endif

const RIPPLE_STRETCH: f32 = 1.6; // how much longer crests are than from one to the next
const RIPPLE_SLOPE: f32 = 1.04; // rms length of the gradient of Perlin noise so stretched

/// Slope of the ripples at `p` (m), as far as they are wider than `footprint` (m); the slope of the rest goes into the
/// variance. `longest` (m) is the length of the longest, `slope` the root mean square slope of all of them. Up to seven
/// noises.
///
/// Each octave holds the same slope, as in the equilibrium range of a wind sea (Phillips 1958), and runs as fast as waves
/// of its length: c² = g / k.
fn ripples(p: vec2f, footprint: f32, longest: f32, slope: f32) -> Waves {
    let each = slope * slope / f32(RIPPLE_OCTAVES); // slope squared of one octave
    var seen = Waves(0.0, vec2f(0.0), 0.0, 0.0);
    var wave_length = longest;
    for (var i = 0; i < RIPPLE_OCTAVES; i++) {
        let presence = wave_presence(wave_length, footprint);
        seen.variance += 0.5 * each * (1.0 - presence * presence);
        if presence > 0.0 {
            // East of the wind and west of it by turns, so that no two octaves run alike.
            let heading = 1.5707963 - water.wind_heading + select(-0.5, 0.42, (i & 1) == 0);
            let speed = sqrt(9.81 * wave_length / 6.2831853);
            let along = rotate2(vec2f(p.x, -p.y), -heading) - vec2f(speed * frame.time, 0.0);
            let squeeze = vec2f(2.0, 2.0 / RIPPLE_STRETCH) / wave_length; // a cell is half a wave
            let n = perlin_noise2_grad(along * squeeze + vec2f(7.3 * f32(i), 3.1), 977u + u32(i));
            let rise = rotate2(n.yz * vec2f(1.0, 1.0 / RIPPLE_STRETCH), heading);
            seen.slope += presence * sqrt(each) / RIPPLE_SLOPE * vec2f(rise.x, -rise.y);
        }
        wave_length *= 0.5;
    }
    return seen;
}
