#include "shared.wgsl"
fn b() -> f32 { return 2.0 * shared_value(); }
