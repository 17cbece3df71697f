#slot noise2: fn(p: vec2f) -> f32
#include <fbm.wgsl> as base with noise2 = noise2
#include <fbm.wgsl> as twice with noise2 = doubled

fn doubled(p: vec2f) -> f32 { return 2.0 * noise2(p); }

fn ridges(p: vec2f) -> f32 { return 1.0 - abs(base_fbm2(p)) - twice_fbm2(p); }
