// How much of the sun reaches the ground that is seen, past other land and clouds and through the air: white is all of it,
// as outside of the air.

#include <color/srgb.wgsl>
#include <geometry/ray.wgsl>
#include <inspect/look.wgsl>
#include <inspect/scale.wgsl>
#include <sky/sky.wgsl>
#include <sun/key.wgsl>

/// Whether clouds throw shadows, as far as the scene has any.
#option inspect.has_clouds = true

#if inspect.has_clouds
#include <clouds/layer.wgsl>
#endif

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Ground that the sun does not reach is
/// blue; slopes are shaded a little, so that the land's forms are seen. Without land, the ground is the sea.
fn main_image(frag_coord: vec2f) -> vec4f {
#if inspect.has_terrain
    let sight = inspect_sight(frag_coord);
    let hit = sight.hit;
    let met = inspect_ground(sight);
    let position = met.position;
    let normal = met.normal;
#else
    let look = inspect_look(frag_coord);
    let way = ray_first(ray_plane(look.origin, look.direction, vec3f(0.0, 1.0, 0.0), 0.0));
    let hit = way < 1e6;
    let position = look.origin + select(0.0, way, hit) * look.direction;
    let normal = vec3f(0.0, 1.0, 0.0);
#endif
    var color = SCALE_NOTHING;
    if hit {
        let day = sky_daylight(position);
        var visible = day.sun / max(key_light(), vec3f(1e-9));
#if inspect.has_terrain
        visible *= terrain_shadow(position, normal, sight.footprint, day);
#endif
#if inspect.has_clouds
        visible *= clouds_shadow(position, day.to_sun);
#endif
        color = mix(vec3f(0.01, 0.02, 0.06), vec3f(1.0), saturate(visible)) * (0.55 + 0.45 * normal.y);
    }
    return vec4f(srgb_encode(color), 1.0);
}
