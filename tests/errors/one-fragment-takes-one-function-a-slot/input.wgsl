#include <fbm.wgsl> with noise2 = one
#include <other.wgsl>
fn one(p: vec2f) -> vec3f { return vec3f(); }
