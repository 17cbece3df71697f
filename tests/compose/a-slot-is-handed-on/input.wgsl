#include <noises.wgsl>
#include <ridges.wgsl> as high with noise2 = perlin2

@fragment fn main() -> @location(0) vec4f {
    return vec4f(high_ridges(vec2f(1)));
}
