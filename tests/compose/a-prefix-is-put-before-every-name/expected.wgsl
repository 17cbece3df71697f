// ---- sun ----
override og_sun_color_x: f32 = 1.0;
override og_sun_color_y: f32 = 2.0;
const og_sun_size: f32 = 2.0;
// ---- options ----
const og_steps: i32 = 8;
struct og_OrogenParams {
    /// How high the sun stands.
    og_sun_elevation: f32,
    /// Its tint.
    og_sun_tint: vec3f,
}
@group(0) @binding(0) var<uniform> og_orogen: og_OrogenParams;

// ---- lib.wgsl ----
const og_workgroup = 8u;

/// One step.
fn og_lib_step(x: f32) -> f32 {
    return x + 1.0;
}

// ---- twice.wgsl as pair ----
/// Two steps.
fn og_pair_twice(x: f32) -> f32 {
    return og_lib_step(og_lib_step(x));
}

// ---- input.wgsl ----
// Everything that has a name of module scope, and what only looks like one.

struct og_Ray {
    steps: f32, // a member keeps its name
    sun: og_Height,
}

alias og_Height = f32;
const og_half_turn = 3.14;
override og_quality: f32 = 1.0;
var<private> og_count: i32 = 0;

@compute @workgroup_size(og_workgroup)
fn og_main(@builtin(global_invocation_id) id: vec3u) {
    let half = og_half_turn; // so does a local
    var ray = og_Ray(half, og_orogen.og_sun_elevation * og_orogen.og_sun_tint.x + vec2f(og_sun_color_x, og_sun_color_y).y + og_sun_size);
    og_count = og_steps + i32(og_quality);
    ray.steps = max(og_pair_twice(ray.steps), og_lib_step(ray.sun));
    _ = ray;
}
