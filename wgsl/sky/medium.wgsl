// What a planet's air is made of: molecules, aerosols and ozone, each with its density over height. The defaults are
// Earth's (Hillaire 2020, after Bruneton 2017), at 680, 550 and 440 nm. sRGB's red lies nearer to 600 nm, where ozone takes
// most: for twilight as blue as the spectrum has it, set Rayleigh scattering to (7.04, 14.39, 33.7) and ozone absorption to
// (2.44, 1.72, 0.01), fitted to the colours of a spectral sky with suns from 30° to 95° from the zenith.

/// Radius of the planet at sea level.
#param sky.ground_radius: f32 = 6360000.0, range 1000 .. 100000000, log, unit m
/// Height of the air above sea level.
#param sky.air_height: f32 = 100000.0, range 100 .. 10000000, log, unit m
/// Scattering by molecules at sea level, in red, green and blue.
#param sky.rayleigh_scattering: vec3f = (5.802, 13.558, 33.1), range 0 .. 10000, unit 1/Mm
/// Height over which the molecules thin out by e.
#param sky.rayleigh_height: f32 = 8000.0, range 10 .. 1000000, log, unit m
/// Scattering by aerosols (haze, dust) at sea level: 4 is clear air, 40 a hazy day.
#param sky.mie_scattering: vec3f = (3.996, 3.996, 3.996), range 0 .. 10000, unit 1/Mm
/// Absorption by aerosols at sea level.
#param sky.mie_absorption: vec3f = (0.444, 0.444, 0.444), range 0 .. 10000, unit 1/Mm
/// Height over which the aerosols thin out by e.
#param sky.mie_height: f32 = 1200.0, range 10 .. 1000000, log, unit m
/// Mean cosine of the angle that aerosols scatter by: 0 all ways alike, near 1 forward.
#param sky.mie_asymmetry: f32 = 0.8, range -0.98 .. 0.98
/// Absorption by ozone at the height of its greatest density.
#param sky.ozone_absorption: vec3f = (0.650, 1.881, 0.085), range 0 .. 10000, unit 1/Mm
/// Height of ozone's greatest density.
#param sky.ozone_center: f32 = 25000.0, range 0 .. 1000000, unit m
/// Height above and below that at which there is none left; between them its density is a tent.
#param sky.ozone_half_width: f32 = 15000.0, range 10 .. 1000000, log, unit m
/// Albedo of the planet's ground, as far as it throws light back into the air.
#param sky.ground_albedo: vec3f = (0.3, 0.3, 0.3), range 0 .. 1

/// Densities at `height` (m) above sea level, 1 at the greatest: (molecules, aerosols, ozone).
fn medium_density(height: f32) -> vec3f {
    let h = max(height, 0.0);
    let tent = max(1.0 - abs(h - sky.ozone_center) / sky.ozone_half_width, 0.0);
    return vec3f(exp(-h / sky.rayleigh_height), exp(-h / sky.mie_height), tent);
}

/// Extinction (1/m) of air with `density` from `medium_density`; of an optical path, in m of each, its optical depth.
fn medium_extinction(density: vec3f) -> vec3f {
    let mie = sky.mie_scattering + sky.mie_absorption;
    return 1e-6 * (density.x * sky.rayleigh_scattering + density.y * mie + density.z * sky.ozone_absorption);
}
