// Head.

#include <a.wgsl>

/// Documented.
#param p.x: f32 = 1.0

#option q = true

// Stays with the function.
fn f() -> f32 {

#if q
    let a = p.x;

#endif
    return a;
}

#param p.y: f32 = 2.0

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f() + p.y + a());
}
