#include <noises.wgsl>
#include <fbm.wgsl> as relief with noise2 = perlin2
#include <fbm.wgsl> as detail with noise2 = value2

@fragment fn main() -> @location(0) vec4f {
    return vec4f(relief_fbm2(vec2f(1)) + detail_fbm2(vec2f(2)) + f32(relief.octaves));
}
