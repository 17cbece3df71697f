#include <shared.wgsl>

fn b() -> f32 { return shared_noise(); }
