// A planet's air: molecules, aerosols and ozone around a sphere, from the ground up to far out in space. How much of it lies
// on a way, and what light it lets through, in closed form. What it scatters is in <sky/scattering.wgsl>.

#include <geometry/ray.wgsl>
#include <light/optical_depth.wgsl>
#include <sky/medium.wgsl>

// Land may lie this far below sea level (m) and still be seen through air; deeper down it does not get thicker.
const ATMOSPHERE_BELOW: f32 = 1000.0;

/// The planet and its air as the closed forms of <light/optical_depth.wgsl> take them.
fn atmosphere_shells() -> AirShells {
    let heights = vec2f(sky.rayleigh_height, sky.mie_height);
    return AirShells(sky.ground_radius, heights, sky.ozone_center, sky.ozone_half_width);
}

/// Part of the light that comes through from the top of the air, 0 .. 1; 0 where the planet is in the way. In closed
/// form.
///
/// `height`: m above the ground, `mu`: cosine of the zenith angle.
fn atmosphere_transmittance(height: f32, mu: f32) -> vec3f {
    let place = AirPlace(max(height, 0.0), mu);
    if mu < 0.0 && air_perigee(place, sky.ground_radius) < 0.0 {
        return vec3f(0.0);
    }
    return atmosphere_clear(place);
}

/// As `atmosphere_transmittance`, the planet left out.
fn atmosphere_clear(place: AirPlace) -> vec3f {
    let shells = atmosphere_shells();
    return exp(-medium_extinction(air_path_to_infinity(shells, place, air_densities(shells, place.height))));
}

/// The part of a ray that lies in the air, and what there is to know of it.
struct AtmosphereWay {
    /// Where it enters the air: the eye, where that is in it.
    start: AirPlace,
    /// Distance from the eye to there (m).
    entry: f32,
    /// From there to its end (m); 0 where it misses the air.
    length: f32,
    /// Height of the lowest point of the whole line (m).
    perigee: f32,
    /// Whether it goes on to the planet's ground, and ends there.
    grounded: bool,
}

/// The way through the air from `eye` to `distance` (m) on. What is farther than `RAY_FAR` ends on the planet; nearer
/// things may lie below sea level, as deep as `ATMOSPHERE_BELOW`.
fn atmosphere_way(eye: AirPlace, distance: f32) -> AtmosphereWay {
    let endless = distance >= RAY_FAR;
    let low = select(-min(ATMOSPHERE_BELOW, 0.1 * sky.ground_radius), 0.0, endless);
    let radius = sky.ground_radius;
    let place = AirPlace(max(eye.height, low), eye.mu);
    let r = radius + place.height;
    let perigee = air_perigee(place, radius);
    if place.height > sky.air_height && (eye.mu >= 0.0 || perigee >= sky.air_height) {
        return AtmosphereWay(place, 0.0, 0.0, perigee, false);
    }
    // Distances along the line, by Pythagoras from its lowest point, as products so that nothing is lost.
    let top = sky.air_height;
    let half_top = sqrt(max((top - perigee) * (2.0 * radius + top + perigee), 0.0));
    let half_low = sqrt(max((low - perigee) * (2.0 * radius + low + perigee), 0.0));
    let down = eye.mu < 0.0 && perigee < low;
    if place.height > top {
        let entry = max(-r * eye.mu - half_top, 0.0);
        let chord = select(2.0 * half_top, (top - low) * (2.0 * radius + top + low) / (half_top + half_low), down);
        let mu = clamp(-half_top / (radius + top), -1.0, 0.0);
        let length = clamp(distance - entry, 0.0, chord);
        return AtmosphereWay(AirPlace(top, mu), entry, length, perigee, down && endless);
    }
    let from_foot = r * eye.mu;
    var chord = half_top - from_foot;
    if eye.mu >= 0.0 {
        chord = (top - place.height) * (2.0 * radius + top + place.height) / max(half_top + from_foot, 1.0);
    } else if down {
        chord = (place.height - low) * (2.0 * radius + place.height + low) / max(half_low - from_foot, 1.0);
    }
    return AtmosphereWay(place, 0.0, min(distance, max(chord, 0.0)), perigee, down && endless);
}
