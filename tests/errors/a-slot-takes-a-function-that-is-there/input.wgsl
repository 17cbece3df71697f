#include <fbm.wgsl> as a with noise2 = perlim2
#include <fbm.wgsl> as b with noise2 = entirely_unlike_all
fn perlin2(p: vec2f) -> vec3f { return vec3f(); }
