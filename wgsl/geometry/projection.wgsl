// Pictures of everything around: equirectangular, and the six faces of a cube.

#include <math/rotation.wgsl>

/// Unit direction at `uv` (0 .. 1 each way, from the bottom left) of an equirectangular picture.
///
/// The middle is north (-z), left and right edge are both south; the bottom edge is straight down all along, the top edge
/// straight up. Azimuth and elevation are even: twice as wide as high, pixels in the middle are square.
fn equirectangular_direction(uv: vec2f) -> vec3f {
    return direction_from_angles(6.2831853 * (uv.x - 0.5), 3.1415927 * (uv.y - 0.5));
}

/// Unit direction at `uv` (0 .. 1 each way, from the bottom left) of face `face`, 0 .. 5, of a cube around the eye.
///
/// Faces are numbered and turned as in the cubemaps of WebGPU, Vulkan and Direct3D (+X -X +Y -Y +Z -Z), whose axes are
/// left-handed: their +Z is north, our -z, so that nothing is mirrored. East, west, up, down, north, south: all upright as
/// seen from the inside; the bottom of `up` and the top of `down` adjoin north. To sample such a cubemap toward `d`, ask
/// it for `vec3f(d.xy, -d.z)`.
fn cube_direction(face: i32, uv: vec2f) -> vec3f {
    let on_face = 2.0 * uv - 1.0;
    var direction = vec3f(1.0, on_face.y, on_face.x);
    switch face {
        case 1: { direction = vec3f(-1.0, on_face.y, -on_face.x); }
        case 2: { direction = vec3f(on_face.x, 1.0, on_face.y); }
        case 3: { direction = vec3f(on_face.x, -1.0, -on_face.y); }
        case 4: { direction = vec3f(on_face.x, on_face.y, -1.0); }
        case 5: { direction = vec3f(-on_face.x, on_face.y, 1.0); }
        default: {}
    }
    return normalize(direction);
}
