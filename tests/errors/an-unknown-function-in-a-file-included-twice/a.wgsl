#include <shared.wgsl>

fn a() -> f32 { return shared_noise(); }
