// What the air between here and there does to light.

/// Air along a part of a ray: what lies behind it is seen as `from_sun` + `from_sky` + `transmittance` · (its radiance).
struct SkyAir {
    /// Sunlight that the air scatters toward the eye on its first encounter: what clouds and mountains can shadow.
    from_sun: vec3f,
    /// All other light that comes from the way: scattered more than once, or from the planet's ground at its end.
    from_sky: vec3f,
    /// Part of the radiance behind that is left, 0 .. 1; 0 where the planet's ground ends the way.
    transmittance: vec3f,
}

/// `radiance` as it is seen through `air`.
fn sky_through(air: SkyAir, radiance: vec3f) -> vec3f {
    return air.from_sun + air.from_sky + air.transmittance * radiance;
}
