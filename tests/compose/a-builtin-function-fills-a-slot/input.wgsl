#include <apply.wgsl> with shape = abs, tone = sqrt

@fragment fn main() -> @location(0) vec4f {
    return vec4f(applied(-1.0));
}
