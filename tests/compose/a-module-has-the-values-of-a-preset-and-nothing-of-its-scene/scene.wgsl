#include <land.wgsl>

#param sky.blue: f32 = 1.0
#option steps = 8

fn main_image(frag_coord: vec2f) -> vec4f {
    return vec4f(land_at(frag_coord), sky.blue, f32(steps), 1.0);
}
