// Which tree is which: each in a colour of its own by its id, the land grey.

#include <color/oklab.wgsl>
#include <color/srgb.wgsl>
#include <noise/pcg.wgsl>
#include <trees/trees.wgsl>
#include <inspect/scale.wgsl>
#include <inspect/sight.wgsl>

/// A colour for `id`, linear sRGB: all are about as light, the hue and a little of the lightness by chance.
fn tree_color(id: u32) -> vec3f {
    let random = pcg2d(vec2u(id, 0x7ee5u));
    let hue = 6.2831853 * f32(random.x >> 8u) / 16777216.0;
    let lightness = mix(0.55, 0.80, f32(random.y >> 8u) / 16777216.0);
    return saturate(oklab_to_linear(vec3f(lightness, 0.11 * cos(hue), 0.11 * sin(hue))));
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Trees are drawn as `trees.*` has
/// them, also where the preset's scene leaves them out.
fn main_image(frag_coord: vec2f) -> vec4f {
    let sight = inspect_sight_over(frag_coord, trees_clearance());
    let tree = trees_trace(sight.origin, sight.direction, sight.clear, sight.distance);
    var color = SCALE_NOTHING;
    if tree.hit {
        color = tree_color(tree.id);
    } else if sight.hit {
        let met = inspect_ground(sight);
        color = vec3f(0.16 * (0.3 + 0.7 * met.normal.y));
    }
    return vec4f(srgb_encode(color), 1.0);
}
