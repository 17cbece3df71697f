// The shadows of the engine's things on Orogen's land: its shadow map, laid over the library's empty file.

#include <view.wgsl>

@group(2) @binding(0) var shadow_map: texture_depth_2d_array;
@group(2) @binding(1) var shadow_compare: sampler_comparison;

const SHADOW_SOFTNESS: f32 = 0.0028; // of the map's width: the sun is no point

/// Part of the sun in the unit direction `to_sun` that the engine's things leave to `position` (m), 0 .. 1.
fn guests_shadow(position: vec3f, to_sun: vec3f) -> f32 {
    var seen = 1.0;
    for (var index = 0; index < THINGS; index++) {
        let clip = view.things[index].sun * vec4f(position - view.things[index].foot, 1.0);
        let at = vec2f(0.5, -0.5) * clip.xy + 0.5;
        // Behind the thing there is shadow without end; before it there is none.
        if any(at <= vec2f(0.01)) || any(at >= vec2f(0.99)) || clip.z <= 0.0 {
            continue;
        }
        let depth = min(clip.z, 1.0);
        var lit = 0.0;
        for (var tap = 0; tap < 9; tap++) {
            let shift = SHADOW_SOFTNESS * vec2f(f32(tap % 3 - 1), f32(tap / 3 - 1));
            lit += textureSampleCompareLevel(shadow_map, shadow_compare, at + shift, index, depth - 0.002);
        }
        seen *= lit / 9.0;
    }
    return seen;
}
