/// Whether it rains.
#option weather.rain = false
/// Whether there is land.
#option weather.land = true

#if weather.rain
#include "rain.wgsl"
#endif
#if weather.land
#include "land.wgsl"
#endif

fn main_image(p: vec2f) -> vec4f { return vec4f(0.0); }
