#include <layer.wgsl> as a
#include <layer.wgsl> as b

@fragment fn main() -> @location(0) vec4f {
    return vec4f(a_density() + b_density() + hash());
}
