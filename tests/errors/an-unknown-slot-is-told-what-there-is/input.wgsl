fn n(p: vec2f) -> vec3f { return vec3f(); }
#include <fbm.wgsl> as relief with nois2 = n
#include <plain.wgsl> with x = n
