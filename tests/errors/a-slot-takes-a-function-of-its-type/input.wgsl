#include <noise.wgsl>
#include <fbm.wgsl> as a with noise2 = perlin2
#include <fbm.wgsl> as b with noise2 = NOISE
#include <fbm.wgsl> as c with noise2 = silent
