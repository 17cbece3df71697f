#include <frame.wgsl>
fn lib() -> f32 { return frame.time; }
