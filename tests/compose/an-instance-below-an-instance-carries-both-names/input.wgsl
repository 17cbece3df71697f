#include <layer.wgsl> as cirrus
#include <layer.wgsl> as cumulus

@fragment fn main() -> @location(0) vec4f {
    return vec4f(cirrus_density(vec2f(1)) + cumulus_density(vec2f(2)));
}
