// The shadows of things that are not Orogen's: a host that draws meshes among the land lays a file of its own over this one.

/// Part of the sun in the unit direction `to_sun` that the host's things leave to `position` (m), 0 .. 1. Here are none: 1.
fn guests_shadow(position: vec3f, to_sun: vec3f) -> f32 {
    return 1.0;
}
