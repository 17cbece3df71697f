// What the weather puts between the eye and what it sees.

#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <sky/air.wgsl>
#include <sky/cirrus.wgsl>
#include <sky/sky.wgsl>

/// The air on the way from `origin` to `distance` (m) along the unit `direction`, from `RAY_FAR` on all the way out, in the
/// light of `day`.
fn weather_air(origin: vec3f, direction: vec3f, distance: f32, day: Daylight) -> SkyAir {
    let air = sky_air(origin, direction, distance);
    if distance < RAY_FAR {
        return air;
    }
    return cirrus_in(air, origin, direction, day);
}
