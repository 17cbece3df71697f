#include "two.wgsl"
#include "../top.wgsl"
fn one() -> f32 { return two() + top(); }
