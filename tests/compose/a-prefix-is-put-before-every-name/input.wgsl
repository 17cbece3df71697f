// Everything that has a name of module scope, and what only looks like one.

#include <lib.wgsl>
#include <twice.wgsl> as pair with step2 = lib_step

/// How high the sun stands.
#param sun.elevation: f32 = 10.0, unit deg
/// Its tint.
#param sun.tint: vec3f = (1, 1, 1)
#param sun.color: vec2f = (1, 2)
#param sun.size: f32 = 2.0
#option steps = 8

struct Ray {
    steps: f32, // a member keeps its name
    sun: Height,
}

alias Height = f32;
const half_turn = 3.14;
override quality: f32 = 1.0;
var<private> count: i32 = 0;

@compute @workgroup_size(workgroup)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let half = half_turn; // so does a local
    var ray = Ray(half, sun.elevation * sun.tint.x + sun.color.y + sun.size);
    count = steps + i32(quality);
    ray.steps = max(pair_twice(ray.steps), lib_step(ray.sun));
    _ = ray;
}
