// Which way the ground faces: east red, up green, south blue, each from -1 (none of it) to 1.

#include <terrain/material.wgsl>
#include <inspect/sight.wgsl>

/// Whose normal: the land's, or with what the ground's cover adds to it, ripples and grain.
#option inspect.normal = land { land, cover }

/// The picture's colour at `frag_coord` (pixels from the bottom left), alpha 1. As in a normal map, the numbers are the
/// display's own.
fn main_image(frag_coord: vec2f) -> vec4f {
    let sight = inspect_sight(frag_coord);
    if !sight.hit {
        return vec4f(0.25, 0.26, 0.27, 1.0);
    }
    let met = inspect_ground(sight);
#if inspect.normal == cover
    let normal = terrain_material(met.position, met.normal, sight.footprint).normal;
#else
    let normal = met.normal;
#endif
    return vec4f(0.5 + 0.5 * normal, 1.0);
}
