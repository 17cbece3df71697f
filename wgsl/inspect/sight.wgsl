// What the ray of a pixel finds of the land: all views through the camera begin with it.

#include <camera/camera.wgsl>
#include <terrain/height.wgsl>
#include <terrain/shade.wgsl>

/// A ray and where it met the land.
struct Sight {
    /// The eye (m).
    origin: vec3f,
    /// Unit vector.
    direction: vec3f,
    /// Whether it met the land.
    hit: bool,
    /// How far it went (m); `terrain.far` where it met nothing.
    distance: f32,
    /// Steps of the march: heights looked up, or single octaves where it goes octave by octave.
    steps: i32,
    /// How far the ray stays above all that stands on the land (m), if that is no higher than it was looked for.
    clear: f32,
    /// Width of the pixel there (m).
    footprint: f32,
}

/// The ray through `frag_coord` (pixels from the bottom left), as the scene marches it.
fn inspect_sight(frag_coord: vec2f) -> Sight {
    return inspect_sight_over(frag_coord, 0.0);
}

/// As `inspect_sight`, where things up to `clearance` (m) high stand on the land.
fn inspect_sight_over(frag_coord: vec2f, clearance: f32) -> Sight {
    let ray = camera_ray(frag_coord, terrain_height(camera.position.xz));
    let approach = terrain_approach(ray.origin, ray.direction, 1.0, clearance);
    let found = approach.hit;
    let footprint = terrain_footprint(found.distance);
    return Sight(ray.origin, ray.direction, found.hit, found.distance, found.steps, approach.clear, footprint);
}

/// Ground that was met.
struct Ground {
    /// On the land, above or below where the ray ended (m).
    position: vec3f,
    /// Unit normal of the land.
    normal: vec3f,
}

/// The ground where `sight` met it, as the scene shades it.
fn inspect_ground(sight: Sight) -> Ground {
    let along = sight.origin + sight.distance * sight.direction;
    let land = terrain_height_grad_filtered(along.xz, sight.footprint);
    return Ground(vec3f(along.x, land.x, along.z), normalize(vec3f(-land.y, 1.0, -land.z)));
}
