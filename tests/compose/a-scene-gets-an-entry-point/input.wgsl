#include <lib.wgsl>

fn main_image(frag_coord: vec2f) -> vec4f {
    return vec4f(frag_coord / frame.resolution, lib(), 1.0);
}
