#include <lib.wgsl>
// A module.

fn one() -> f32 { return of_library(); }
fn two() -> f32 { return 2.0; }
struct Three { x: f32 }
