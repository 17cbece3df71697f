diagnostic(off, derivative_uniformity);
#include <a.wgsl>
@fragment fn main() -> @location(0) vec4f {
    return vec4f(a());
}
