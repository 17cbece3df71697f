#include <hash.wgsl>
fn density() -> f32 { return hash(); }
