#include <fbm.wgsl> as a with noise2 = one, noise2 = two
fn one(p: vec2f) -> vec3f { return vec3f(); }
fn two(p: vec2f) -> vec3f { return vec3f(); }
