// Where the picture is taken from, and with which lens.

#include <frame.wgsl>
#include <geometry/projection.wgsl>
#include <math/rotation.wgsl>

/// What the picture shows: what is ahead, through a lens; or everything around, `equirectangular` (a panorama twice as
/// wide as high, the middle toward `camera.azimuth`, the horizon level) or on the six faces of a `cube` (a skybox: +X -X
/// +Y -Y +Z -Z from the top, or from the left where the picture is wider than high; north is its +Z).
#option camera.projection = perspective { perspective, equirectangular, cube }

/// Where the camera stands: east, up, south.
#param camera.position: vec3f = (0, 2, 0), unit m
/// Whether the camera's height is counted from the ground beneath it, and not from sea level.
#option camera.above_ground = true
/// The camera never comes nearer to the ground beneath it than this.
#param camera.clearance: f32 = 1.6, range 0 .. 1000, unit m
/// How the view is given: by azimuth and elevation, or by a point to look at.
#option camera.aim = angles { angles, point }
/// Direction of view, clockwise from north.
#param camera.azimuth: f32 = 0.0, range -360 .. 360, unit deg
/// Direction of view above the horizon; below it is negative.
#param camera.elevation: f32 = 0.0, range -89 .. 89, unit deg
/// The point in the middle of the picture, where `camera.aim` is `point`.
#param camera.look_at: vec3f = (0, 0, -1000), unit m
/// Focal length on a frame 36 mm wide: 24 is wide, 50 normal, 85 long.
#param camera.focal_length: f32 = 35.0, range 8 .. 1200, log, unit mm
/// How far the view turns when the mouse is dragged across the whole picture: what is seen goes with the mouse. Up and down
/// it stops at 89 deg, and a panorama only turns to the sides.
#param camera.drag: f32 = 180.0, range 0 .. 720, unit deg

const HALF_FRAME: f32 = 18.0; // mm

/// A ray from the eye through a pixel.
struct CameraRay {
    /// The eye (m).
    origin: vec3f,
    /// Unit vector.
    direction: vec3f,
}

/// The ray through `frag_coord` (pixels from the bottom left; whoever calls adds `frame.jitter` to it).
///
/// `ground_height`: height of the ground (m) beneath `camera.position`.
fn camera_ray(frag_coord: vec2f, ground_height: f32) -> CameraRay {
    var origin = camera.position;
#if camera.above_ground
    origin.y += ground_height;
#endif
    origin.y = max(origin.y, ground_height + camera.clearance);

#if camera.projection == cube
    let direction = camera_on_cube(frag_coord);
#else
#if camera.aim == point
    let aim = normalize_or(camera.look_at - origin, vec3f(0.0, 0.0, -1.0));
    var azimuth = atan2(aim.x, -aim.z + select(0.0, 1e-9, aim.x == 0.0 && aim.z == 0.0));
    var elevation = asin(clamp(aim.y, -1.0, 1.0));
#else
    var azimuth = camera.azimuth;
    var elevation = camera.elevation;
#endif
    let drag = (frame.mouse.xy - abs(frame.mouse.zw)) / frame.resolution.x;
    azimuth -= camera.drag * drag.x;
    elevation = clamp(elevation - camera.drag * drag.y, -1.5533430, 1.5533430); // 89 deg

#if camera.projection == equirectangular
    let turned = frag_coord / frame.resolution + vec2f(azimuth / 6.2831853, 0.0);
    let direction = equirectangular_direction(turned);
#else
    let forward = direction_from_angles(azimuth, elevation);
    let right = vec3f(cos(azimuth), 0.0, sin(azimuth));
    let up = cross(right, forward);
    let centred = (2.0 * frag_coord - frame.resolution) / frame.resolution.x;
    let on_film = HALF_FRAME / camera.focal_length * centred;
    let direction = normalize(forward + on_film.x * right + on_film.y * up);
#endif
#endif
    return CameraRay(origin, direction);
}

#if camera.projection == cube
/// How many faces of the cube stand beside and above each other in the picture.
fn camera_faces() -> vec2f {
    return select(vec2f(1.0, 6.0), vec2f(6.0, 1.0), frame.resolution.x > frame.resolution.y);
}

/// Unit direction through `frag_coord` where the picture is the six faces of a cube.
fn camera_on_cube(frag_coord: vec2f) -> vec3f {
    let faces = camera_faces();
    let face_size = frame.resolution / faces;
    // By the pixel's centre: no rounding takes an edge to the face beside it.
    let at = floor((floor(frag_coord) + 0.5) / face_size);
    let face = select(5.0 - at.y, at.x, faces.x > 1.0);
    return cube_direction(i32(clamp(face, 0.0, 5.0)), frag_coord / face_size - at);
}
#endif

/// Angle that a pixel in the middle of the picture (of a face of the cube) covers (rad).
fn camera_pixel_angle() -> f32 {
#if camera.projection == cube
    return 2.0 * camera_faces().x / frame.resolution.x;
#elif camera.projection == equirectangular
    return 6.2831853 / frame.resolution.x;
#else
    return 2.0 * HALF_FRAME / (camera.focal_length * frame.resolution.x);
#endif
}
