// What the ground is made of: its albedo, without light.

#include <color/srgb.wgsl>
#include <terrain/material.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>

/// How much brighter than they are albedos are shown: each step doubles them. At 0 a wet forest is nearly black.
#param inspect.albedo_exposure: f32 = 0.0, range -8 .. 8, unit EV

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let sight = inspect_sight(frag_coord);
    var color = SCALE_NOTHING;
    if sight.hit {
        let met = inspect_ground(sight);
        let albedo = terrain_material(met.position, met.normal, sight.footprint).albedo;
        color = saturate(albedo * exp2(inspect.albedo_exposure));
    }
    return vec4f(srgb_encode(color), 1.0);
}
