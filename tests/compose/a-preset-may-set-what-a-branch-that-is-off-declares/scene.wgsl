#option wet = true
#if wet
#include <sea.wgsl>
#endif

@fragment
fn main() -> @location(0) vec4f {
#if wet
    return vec4f(sea.level);
#else
    return vec4f(0.5);
#endif
}
