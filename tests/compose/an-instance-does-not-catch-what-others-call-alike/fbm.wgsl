#include "noise.wgsl"

fn fbm(x: f32) -> f32 {
    return noise(x) + sin(x);
}
