#include <fbm.wgsl> with noise2 = two
fn two(p: vec2f) -> vec3f { return vec3f(); }
