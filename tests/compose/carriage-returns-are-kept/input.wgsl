// Head.

#include <a.wgsl>

/// Doc.
#param p.x: f32 = 1.0
#option on = true

@fragment
fn main() -> @location(0) vec4f {
#if on
    return vec4f(p.x + a());
#else
    return vec4f(0.0);
#endif
}
