#include <noise.wgsl>
#include <layer.wgsl> as cirrus

@fragment fn main() -> @location(0) vec4f {
    return vec4f(cirrus_cover());
}
