alias Place = vec2<f32>;
fn noise(p: Place) -> f32 { return p.x; }
#include <apply.wgsl> with noise2 = noise

@fragment fn main() -> @location(0) vec4f {
    return vec4f(applied());
}
