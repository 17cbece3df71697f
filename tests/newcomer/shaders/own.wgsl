// A host's own shader: a parameter of every type, names that are words of Rust, and a binding of every kind.

#include <sky/atmosphere.wgsl>
#include "beside.wgsl"

/// Whether there is any.
#param type.on: bool = false
/// How many.
#param type.count: u32 = 3, range 0 .. 10
#param type.move: vec3f = (1, 2, 3), unit m
/// Less than none.
#param type.self: i32 = -4
/// How far it bends.
#param two_words.bend: f32 = 45, range -180 .. 180, unit deg
/// Where.
#param two_words.place: vec2f = (0.5, 0.25)
#param two_words.tint: vec4f = (0.1, 0.2, 0.3, 1), color

struct Item {
    place: vec4f,
    weight: f32,
}

@group(1) @binding(0) var<storage> items: array<Item>;
@group(1) @binding(1) var<storage, read_write> sums: array<f32>;
@group(1) @binding(2) var picture: texture_2d<f32>;
@group(1) @binding(3) var linear: sampler;
@group(1) @binding(4) var shadows: texture_depth_2d_array;
@group(1) @binding(5) var nearer: sampler_comparison;
@group(1) @binding(6) var written: texture_storage_2d<rgba8unorm, write>;
@group(1) @binding(7) var counts: texture_2d<u32>;

fn own_sum() -> f32 {
    let all = type.move.x + f32(type.self) + f32(type.count) + two_words.bend + two_words.place.y + two_words.tint.w;
    return select(0.0, all, type.on);
}

@compute @workgroup_size(8, 8)
fn measure(@builtin(global_invocation_id) id: vec3u) {
    let at = vec2f(id.xy) / 64.0;
    var sum = own_sum() + beside_weight() + items[id.x].weight + atmosphere_transmittance(0.0, 1.0).x;
    sum += textureSampleLevel(picture, linear, at, 0.0).x + f32(textureLoad(counts, id.xy, 0).x);
    sum += textureSampleCompareLevel(shadows, nearer, at, 0, 0.5);
    sums[id.x] = sum;
    textureStore(written, id.xy, vec4f(sum));
}
