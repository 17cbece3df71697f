// What the engine tells its shaders: the camera, and the things that stand in the world.

/// One thing: where it stands, which way it is turned, and how the sun sees it.
struct Thing {
    /// Its foot (m).
    foot: vec3f,
    /// How many times its mesh it is large.
    scale: f32,
    /// Cosine and sine of its heading.
    turn: vec2f,
    /// From places relative to its foot to its layer of the shadow map.
    sun: mat4x4f,
}

const THINGS: i32 = 2;

/// The camera. Places are relative to the eye: no digits are lost far from the world's origin.
struct View {
    clip_from_eye: mat4x4f,
    eye_from_clip: mat4x4f,
    /// The eye (m).
    eye: vec3f,
    /// Size of the picture (px).
    size: vec2f,
    things: array<Thing, THINGS>,
}

@group(0) @binding(0) var<uniform> view: View;

/// Unit direction in which a pixel looks; `at` is counted from the top left.
fn view_ray(at: vec2f) -> vec3f {
    let clip = vec2f(2.0, -2.0) * at / view.size + vec2f(-1.0, 1.0);
    let near = view.eye_from_clip * vec4f(clip, 1.0, 1.0);
    return normalize(near.xyz / near.w);
}
