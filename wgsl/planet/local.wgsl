// A planet's ground around the world's origin as a land: height over a plane, for all that stands on land.
//
// The plane touches the planet in the origin; the farther from there, the lower the sea level beneath it. Good for tens of
// kilometres, as long as upward is upward.

#include <camera/camera.wgsl>
#include <planet/height.wgsl>

/// Height of the land (m) over the plane at `p` (m) and its slope: (height, rise to the east, to the south), without what is
/// too small to be seen in a pixel `footprint` (m) wide.
fn local_height_grad(p: vec2f, footprint: f32) -> vec3f {
    // Looked up at the camera's height: what is upward leans there by less than the land's height over the radius.
    let above = vec3f(p.x, camera.position.y, p.y);
    let up = planet_up(above);
    let ground = planet_ground(above, footprint);
    let drop = (ground.height - planet_altitude(above)) * up.y;
    return vec3f(above.y + drop, ground.slope.xz - up.xz / max(up.y, 0.1));
}

/// A height (m) over the plane that the land nowhere exceeds.
fn local_ceiling() -> f32 {
    return planet_ceiling();
}
