#include "lib/two.wgsl"
fn one() -> f32 { return two(); }
