#include <layer.wgsl> as high
#include <sun.wgsl>

@fragment fn main() -> @location(0) vec4f {
    return vec4f(high_light());
}
