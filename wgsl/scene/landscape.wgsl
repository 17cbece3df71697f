// A landscape: land under a clear sky.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <sky/cirrus.wgsl>
#include <sky/gradient.wgsl>
#include <terrain/height.wgsl>
#include <terrain/shade.wgsl>

/// Whether trees stand on the land.
#option landscape.trees = false

#if landscape.trees
#include <trees/trees.wgsl>
#endif

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m); `terrain.far` for the sky.
    distance: f32,
}

/// What is seen from `origin` (m) in the unit `direction`.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    let hit = terrain_trace(origin, direction);
#if landscape.trees
    let tree = trees_trace(origin, direction, 0.0, hit.distance);
    if tree.hit {
        let crown = origin + tree.distance * direction;
        let pixel = terrain_footprint(tree.distance);
        let sun_left = terrain_shadow(crown, sun_direction(), pixel) * trees_shadow(crown, pixel);
        let leaves = trees_shade(origin, direction, tree, sun_left);
        return Traced(sky_veil(leaves, origin, direction, tree.distance), tree.distance);
    }
#endif
    if !hit.hit {
        let clear = sky_radiance(direction) + sun_disc(direction);
        return Traced(cirrus_veil(clear, origin, direction), terrain.far);
    }
    let footprint = terrain_footprint(hit.distance);
    let along = origin + hit.distance * direction;
    let land = terrain_height_grad_filtered(along.xz, footprint);
    let position = vec3f(along.x, land.x, along.z);
    let normal = normalize(vec3f(-land.y, 1.0, -land.z));
    var sun_seen = terrain_shadow(position, normal, footprint);
#if landscape.trees
    sun_seen *= trees_shadow(position, footprint);
#endif
    let radiance = terrain_shade(position, normal, footprint, sun_seen);
    return Traced(sky_veil(radiance, origin, direction, hit.distance), hit.distance);
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, terrain_height(camera.position.xz));
    let seen = scene_trace(ray.origin, ray.direction);
    return vec4f(display_color(seen.radiance), 1.0);
}
