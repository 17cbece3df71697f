// From scene light to what a display can show.

/// 1 - e^(-x) in each channel: 0 .. 1 for light >= 0, never clips, slope 1 in the dark.
fn tone_map_exponential(radiance: vec3f) -> vec3f {
    return 1.0 - exp(-max(radiance, vec3f(0.0)));
}
