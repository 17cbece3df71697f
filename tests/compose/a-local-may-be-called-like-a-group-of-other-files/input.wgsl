#include "lamp.wgsl"

@fragment fn main() -> @location(0) vec4f {
    let sun = vec2f(0.5, 1.0);
    return vec4f(sun.x * lamp(), sun, 1.0);
}
