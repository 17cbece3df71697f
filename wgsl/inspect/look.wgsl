// The ray of a pixel up to what ends it: views of the air and of clouds begin with it, in scenes with land and without.

#include <geometry/ray.wgsl>

/// Whether there is land, as far as the scene has any: it carries the camera and ends rays.
#option inspect.has_terrain = true

#if inspect.has_terrain
#include <inspect/sight.wgsl>
#else
#include <camera/camera.wgsl>
#endif

/// A ray and where it ends.
struct Look {
    /// The eye (m).
    origin: vec3f,
    /// Unit vector.
    direction: vec3f,
    /// Whether land ends it.
    hit: bool,
    /// How far it goes (m); `RAY_FAR` where nothing ends it.
    distance: f32,
}

/// The ray through `frag_coord` (pixels from the bottom left).
fn inspect_look(frag_coord: vec2f) -> Look {
#if inspect.has_terrain
    let sight = inspect_sight(frag_coord);
    return Look(sight.origin, sight.direction, sight.hit, select(RAY_FAR, sight.distance, sight.hit));
#else
    let ray = camera_ray(frag_coord, 0.0);
    return Look(ray.origin, ray.direction, false, RAY_FAR);
#endif
}
