
// ---- lib.wgsl ----
fn of_library() -> f32 { return 1.0; }

// ---- input.wgsl ----
// A module.

fn one() -> f32 { return of_library(); }
fn two() -> f32 { return 2.0; }
struct Three { x: f32 }
