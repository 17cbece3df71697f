#include <fbm.wgsl> as detail with noise2 = perlin2
fn cover() -> f32 { return detail_fbm2(vec2f(1.0)); }
