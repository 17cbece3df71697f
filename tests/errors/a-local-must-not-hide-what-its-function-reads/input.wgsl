#include <lib.wgsl> as my
#param sun.power: f32 = 1.0

@fragment fn main() -> @location(0) vec4f {
    return vec4f(my_f(f(sun.power)));
}

fn f(x: f32) -> f32 {
    let sun_power = x;
    return sun_power * sun.power;
}
