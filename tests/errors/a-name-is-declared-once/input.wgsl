#include <a.wgsl>
#include <b.wgsl>
#param sun.power: f32 = 1.0

fn helper() -> f32 { return 1.0; }
const sun_power = 2;
