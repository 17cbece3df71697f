// How much air a straight way through a planet's atmosphere passes, in closed form: no march.
//
// Two kinds of air that thin out exponentially with height (the Chapman function, 1931) and one whose density is a tent
// over height. An optical path is the length (m) of air of density 1 that holds as much; times the extinction of such
// air (1/m) it is an optical depth.

/// The air around a planet.
struct AirShells {
    /// Radius of the planet (m): where height is 0.
    radius: f32,
    /// Heights (m) over which the first two kinds thin out by e; their density is 1 at height 0.
    scale_height: vec2f,
    /// Height (m) at which the third kind's density is 1.
    tent_center: f32,
    /// Height (m) above and below that at which it is 0.
    tent_half_width: f32,
}

/// A place along a way through the air.
struct AirPlace {
    /// Height (m) above the planet's radius.
    height: f32,
    /// Cosine of the angle between the way and the vertical there: below 0 it leads down.
    mu: f32,
}

/// The place `t` (m) further on a way. Exact also for a metre near a planet's ground: no large numbers are subtracted.
fn air_place_after(start: AirPlace, t: f32, radius: f32) -> AirPlace {
    let r = radius + start.height;
    let gained = t * (t + 2.0 * r * start.mu); // of the squared radius
    let r_there = sqrt(max(r * r + gained, 1.0));
    return AirPlace(start.height + gained / (r + r_there), clamp((r * start.mu + t) / r_there, -1.0, 1.0));
}

/// Height (m) of the lowest point of the whole line through `place`.
fn air_perigee(place: AirPlace, radius: f32) -> f32 {
    let r = radius + place.height;
    let sine = sqrt(max((1.0 - place.mu) * (1.0 + place.mu), 0.0));
    if place.height > radius {
        return r * sine - radius; // from far away, the smaller error
    }
    return place.height - r * place.mu * place.mu / (1.0 + sine);
}

/// Densities of the two exponential kinds at `height` (m). Finite also far below the ground.
fn air_densities(shells: AirShells, height: f32) -> vec2f {
    return exp(clamp(-height / shells.scale_height, vec2f(-87.0), vec2f(40.0)));
}

/// Chapman's function of a rising ray: its optical path to infinity, over that of a vertical one through flat air.
///
/// `x`: distance from the planet's centre in scale heights, `mu` 0 .. 1: cosine of the angle to the vertical. Between 1
/// and sqrt(pi x / 2). With w = u + u²/2x in place of the height u in scale heights, it is the integral of e^(−w) (1 +
/// w²/2x + …) / sqrt(mu² + 2w/x): e^(y²) erfc(y), y = mu sqrt(x/2), and a correction of the order 1/x; both are fitted
/// by rational functions. Relative error below 1e-5 for x >= 200, 3e-4 for x >= 30, 2e-3 for x >= 10.
fn chapman_rising(x: vec2f, mu: f32) -> vec2f {
    let half = sqrt(0.5 * x);
    let y = mu * half;
    let under = (1.27323954 + y * (1.82333405 + y * (0.97922388 + y * 0.2359145)))
        / (1.0 + y * (0.94764333 + y * (0.49143231 + y * 0.11795725)));
    let curved = (0.75 + y * (1.29130337 + y * 0.8763201)) / (1.0 + y * (0.6290814 + y * 0.43816005));
    return half * 2.0 / (y + sqrt(y * y + under)) * (1.0 + 0.5 * curved / x);
}

/// Optical path (m) of a rising ray through the tent: elementary, since the height along a ray is almost a parabola.
///
/// Hermite quadrature, mended by the fourth derivative, between the heights where the tent bends; error below 1e-4 of it at
/// Earth's radius.
fn air_path_tent(shells: AirShells, height: f32, mu: f32) -> f32 {
    let r = shells.radius + height;
    let low = shells.tent_center - shells.tent_half_width;
    let high = shells.tent_center + shells.tent_half_width;
    if height >= high {
        return 0.0;
    }
    let knots = max(vec3f(low, shells.tent_center, high), vec3f(height));
    let climb = knots - height;
    let gained = climb * (2.0 * r + climb);
    let from_foot = r * mu;
    let reached = sqrt(from_foot * from_foot + gained);
    let t = gained / max(reached + from_foot, vec3f(1e-3));
    let slope = reached / (r + climb);
    let rising = knots.xy - low;
    let falling = high - knots.yz;
    let first = t.y - t.x;
    let second = t.z - t.y;
    let span = vec2f(first, second);
    let bent = span * span / r; // what is not a parabola: its fourth derivative is -3 / r^3
    let quartic = bent * bent * span / (120.0 * r);
    let twice = first * (rising.x + rising.y + first * (slope.x - slope.y) / 6.0) - quartic.x
        + second * (falling.x + falling.y + second * (slope.z - slope.y) / 6.0) + quartic.y;
    return max(0.5 * twice / shells.tent_half_width, 0.0);
}

/// Optical paths (m) of a ray from `place` up to infinity, by kind; `place.mu` 0 .. 1. `densities`: `air_densities`
/// there.
fn air_path_rising(shells: AirShells, place: AirPlace, densities: vec2f) -> vec3f {
    let x = (shells.radius + place.height) / shells.scale_height;
    let exponential = densities * shells.scale_height * chapman_rising(x, place.mu);
    return vec3f(exponential, air_path_tent(shells, place.height, place.mu));
}

/// Optical paths (m) of the whole half-line that rises from the lowest point of a way, `perigee` (m) high.
fn air_path_from_perigee(shells: AirShells, perigee: f32) -> vec3f {
    return air_path_rising(shells, AirPlace(perigee, 0.0), air_densities(shells, perigee));
}

/// Optical paths (m) of a ray from `place` in any direction to infinity, by kind; the planet does not stop it. Down and
/// up again it is twice the path from the lowest point, less the path behind.
///
/// Within .1 % for planets of at least 30 scale heights; never negative, finite for every height. `densities`:
/// `air_densities` at `place`.
fn air_path_to_infinity(shells: AirShells, place: AirPlace, densities: vec2f) -> vec3f {
    let rising = air_path_rising(shells, AirPlace(place.height, abs(place.mu)), densities);
    if place.mu >= 0.0 {
        return rising;
    }
    return max(2.0 * air_path_from_perigee(shells, air_perigee(place, shells.radius)) - rising, vec3f(0.0));
}

/// Optical paths (m) of `distance` (m) on from `place`, by kind: the difference of two paths to infinity.
///
/// Of a short way the error is up to a metre of such air (f32 holds no more of a path to infinity): nothing that one
/// could see; never negative.
fn air_path_between(shells: AirShells, place: AirPlace, distance: f32) -> vec3f {
    let end = air_place_after(place, distance, shells.radius);
    let here = air_path_rising(shells, AirPlace(place.height, abs(place.mu)), air_densities(shells, place.height));
    let there = air_path_rising(shells, AirPlace(end.height, abs(end.mu)), air_densities(shells, end.height));
    if place.mu >= 0.0 {
        return max(here - there, vec3f(0.0));
    }
    if end.mu <= 0.0 {
        return max(there - here, vec3f(0.0));
    }
    let lowest = air_path_from_perigee(shells, air_perigee(place, shells.radius));
    return max(2.0 * lowest - here - there, vec3f(0.0));
}
