// The light that a planet's air scatters: its sky by day and by night, and what it adds to things far away.

#include <geometry/globe.wgsl>
#include <geometry/ray.wgsl>
#include <light/optical_depth.wgsl>
#include <light/phase.wgsl>
#include <sky/air.wgsl>
#include <sky/atmosphere.wgsl>
#include <sky/beyond.wgsl>
#include <sky/medium.wgsl>
#include <sky/nodes.wgsl>
#include <sky/orders.wgsl>
#include <sun/key.wgsl>
#include <sun/moon.wgsl>
#include <sun/sun.wgsl>

/// Whether light counts that was scattered more than once or thrown back by the ground.
#option sky.multiple_scattering = true

/// What a way through the air adds to and leaves of what is behind it, for a distant light of irradiance 1.
struct AtmosphereLit {
    /// Scattered once.
    from_light: vec3f,
    /// All else.
    from_sky: vec3f,
}

/// The part of a way that lies in the planet's shadow, as distances from its start: `near` >= `far` where none does.
///
/// `light_mu`: cosine of the light's zenith angle at the start; `nu`: cosine between way and light, `sine2` its sine
/// squared; `aside`: dot of the vertical at the start with the part of the way's direction that is across to the light.
fn atmosphere_shadow(way: AtmosphereWay, light_mu: f32, nu: f32, sine2: f32, aside: f32) -> RaySpan {
    let r = sky.ground_radius + way.start.height;
    let along = r * light_mu;
    let a = max(sine2, 1e-12);
    let b = r * aside;
    let c = way.start.height * (2.0 * sky.ground_radius + way.start.height) - along * along;
    let discriminant = b * b - a * c;
    if discriminant <= 0.0 {
        return ray_missed();
    }
    // Where the line is within the cylinder of the shadow.
    let q = -(b + select(-1.0, 1.0, b >= 0.0) * sqrt(discriminant));
    let first = q / a;
    let second = c / select(q, 1e-6, q == 0.0);
    var near = min(first, second);
    var far = max(first, second);
    // And on the far side of the planet.
    if abs(nu) > 1e-6 {
        let middle = -along / nu;
        near = select(max(near, middle), near, nu > 0.0);
        far = select(far, min(far, middle), nu > 0.0);
    } else if light_mu >= 0.0 {
        return ray_missed();
    }
    return RaySpan(clamp(near, 0.0, way.length), clamp(far, 0.0, way.length));
}

/// The light scattered to the eye along `way`.
///
/// The integral is broken where the planet's shadow begins and ends and at the lowest point; each part has its own
/// nodes, which crowd where the air is dense. `left` is what comes through of light behind: where that is much and the
/// way keeps to its height, few nodes do.
fn atmosphere_lit(way: AtmosphereWay, left: vec3f, light_mu: f32, nu: f32, sine2: f32, aside: f32) -> AtmosphereLit {
    var lit = AtmosphereLit(vec3f(0.0), vec3f(0.0));
    let shells = atmosphere_shells();
    let radius = sky.ground_radius;
    let r = radius + way.start.height;
    let falls = way.start.mu < 0.0;
    let before = air_path_rising(
        shells,
        AirPlace(way.start.height, abs(way.start.mu)),
        air_densities(shells, way.start.height),
    );
    let foot = clamp(-r * way.start.mu, 0.0, way.length);
    var beyond = before; // of the whole line from the start, had it no end
    if falls && foot < way.length {
        beyond = 2.0 * air_path_from_perigee(shells, way.perigee) - before;
    }
    let end_height = air_place_after(way.start, way.length, radius).height;
    let lowest = select(min(way.start.height, end_height), way.perigee, falls && foot < way.length);
    let rise = max(way.start.height, end_height) - lowest;
    let clear = min(left.x, min(left.y, left.z)) > 0.37 && rise < 3.0 * min(sky.mie_height, sky.rayleigh_height);
    let count = select(SKY_NODES, SKY_NODES_NEAR, clear);

    let shadow = atmosphere_shadow(way, light_mu, nu, sine2, aside);
    let dark = shadow.near < shadow.far;
    let dusk = select(way.length, shadow.near, dark);
    let dawn = select(way.length, shadow.far, dark);
    let edges = vec4f(min(foot, dusk), max(min(foot, dawn), dusk), max(foot, dawn), way.length);

    let rayleigh = 1e-6 * phase_rayleigh(nu) * sky.rayleigh_scattering;
    let mie = 1e-6 * phase_cornette_shanks(nu, sky.mie_asymmetry) * sky.mie_scattering;
    var begin = 0.0;
    for (var part = 0; part < 4; part++) {
        let end = edges[part];
        let length = end - begin;
        let middle = 0.5 * (begin + end);
        let shaded = dark && middle > dusk && middle < dawn;
#if sky.multiple_scattering
        let idle = length <= 0.0;
#else
        let idle = length <= 0.0 || shaded;
#endif
        if !idle {
            let from_height = air_place_after(way.start, begin, radius).height;
            let drop = from_height - air_place_after(way.start, end, radius).height;
            let from_end = smoothstep(1.0, 4.0, drop / sky.rayleigh_height);
            for (var i = 0; i < count; i++) {
                let node = sky_node(i, count, from_end);
                let t = begin + length * node.x;
                let weight = length * node.y;

                let place = air_place_after(way.start, t, radius);
                let densities = air_densities(shells, place.height);
                let after = air_path_rising(shells, AirPlace(place.height, abs(place.mu)), densities);
                let path = max(select(beyond - after, after - before, falls && t < foot), vec3f(0.0));
                let seen = weight * exp(-medium_extinction(path));
                let place_mu = clamp((r * light_mu + t * nu) / (radius + place.height), -1.0, 1.0);
                if !shaded {
                    let from_light = air_path_to_infinity(shells, AirPlace(place.height, place_mu), densities);
                    let sunlit = exp(-medium_extinction(from_light));
                    lit.from_light += seen * sunlit * (densities.x * rayleigh + densities.y * mie);
                }
#if sky.multiple_scattering
                lit.from_sky += seen * orders_source(place.height, place_mu, place.mu, nu);
#endif
            }
        }
        begin = end;
    }
    return lit;
}

/// Radiance of the sky for a sun of irradiance 1: all orders and the sunlit ground, or with `sky.multiple_scattering`
/// off single scattering by the air alone.
///
/// `height`: m above the ground. `view`, `to_sun`: unit vectors to what is seen and to the sun, y up at that place.
fn atmosphere_radiance(height: f32, view: vec3f, to_sun: vec3f) -> vec3f {
    let way = atmosphere_way(AirPlace(height, clamp(view.y, -1.0, 1.0)), RAY_FAR);
    let air = atmosphere_seen(way, atmosphere_entry_up(way, height, vec3f(0.0, 1.0, 0.0), view), view, to_sun);
    return air.from_sun + air.from_sky;
}

/// The air from `origin` (m; `origin.y` above sea level) to `distance` (m) along the unit `direction`; from `RAY_FAR`
/// on all of it, and the planet's sunlit ground where the ray ends on that.
fn atmosphere_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
    let up = globe_up(origin, sky.ground_radius);
    let height = globe_height(origin, sky.ground_radius);
    let way = atmosphere_way(AirPlace(height, clamp(dot(up, direction), -1.0, 1.0)), distance);
    let entry_up = atmosphere_entry_up(way, height, up, direction);
    var air = SkyAir(vec3f(0.0), vec3f(0.0), vec3f(1.0));
    for (var i = 0; i < ATMOSPHERE_LIGHTS; i++) {
        if i == 1 && sun.elevation > 0.1 {
            break; // by day nothing is seen of the moon's light
        }
        let light = atmosphere_light(i);
        let seen = atmosphere_seen(way, entry_up, direction, light.toward);
        air.from_sun += light.irradiance * select(vec3f(0.0), seen.from_sun, light.is_key);
        air.from_sky += light.irradiance * (seen.from_sky + select(seen.from_sun, vec3f(0.0), light.is_key));
        air.transmittance = seen.transmittance;
    }
    return air;
}

/// A distant light that the air scatters.
struct AtmosphereLight {
    /// Unit vector to it.
    toward: vec3f,
    /// Irradiance of a surface that faces it, outside of the air.
    irradiance: vec3f,
    /// Whether it is the one that throws the shadows.
    is_key: bool,
}

#if moon.shines
const ATMOSPHERE_LIGHTS: i32 = 2;
#else
const ATMOSPHERE_LIGHTS: i32 = 1;
#endif

/// Light number `index`: the sun, then the moon if it shines.
fn atmosphere_light(index: i32) -> AtmosphereLight {
#if moon.shines
    if index == 1 {
        return AtmosphereLight(moon_direction(), moon_light(), key_is_moon());
    }
    return AtmosphereLight(sun_direction(), sun_light(), !key_is_moon());
#else
    return AtmosphereLight(sun_direction(), sun_light(), true);
#endif
}

/// Irradiance of a surface that faces the light that throws the shadows: what the air lets through of it, and of its
/// disc what stands above the horizon.
fn atmosphere_sunlight(position: vec3f) -> vec3f {
    let height = max(globe_height(position, sky.ground_radius), 0.0);
    let r = sky.ground_radius + height;
    let mu = atmosphere_mu(position, key_direction());
    let horizon = -sqrt(height * (2.0 * sky.ground_radius + height)) / r;
    let risen = asin(mu) - asin(horizon);
    let seen = smoothstep(-key_radius(), key_radius(), risen);
    if seen <= 0.0 {
        return vec3f(0.0);
    }
    return seen * key_light() * atmosphere_clear(AirPlace(height, max(mu, horizon)));
}

/// Irradiance of level ground at `position` (m) by the whole sky, without the light that throws the shadows.
fn atmosphere_irradiance(position: vec3f) -> vec3f {
    let height = max(globe_height(position, sky.ground_radius), 0.0);
    var irradiance = sky_beyond_irradiance();
    for (var i = 0; i < ATMOSPHERE_LIGHTS; i++) {
        let light = atmosphere_light(i);
        irradiance += light.irradiance * orders_irradiance(height, atmosphere_mu(position, light.toward));
    }
    return irradiance;
}

/// Cosine of the zenith angle, at `position`, of a light in the direction `to_light`.
fn atmosphere_mu(position: vec3f, to_light: vec3f) -> f32 {
    return clamp(dot(globe_up(position, sky.ground_radius), to_light), -1.0, 1.0);
}

/// The vertical where `way` enters the air, from that at the eye, `height` (m) up.
fn atmosphere_entry_up(way: AtmosphereWay, height: f32, up: vec3f, direction: vec3f) -> vec3f {
    return normalize(up + way.entry / (sky.ground_radius + max(height, 0.0)) * direction);
}

/// The air along `way`, with `up` the vertical where it enters the air, for a distant light of irradiance 1.
fn atmosphere_seen(way: AtmosphereWay, up: vec3f, direction: vec3f, to_light: vec3f) -> SkyAir {
    if way.length <= 0.0 && !way.grounded {
        return SkyAir(vec3f(0.0), vec3f(0.0), vec3f(1.0));
    }
    let nu = dot(direction, to_light);
    let normal = cross(direction, to_light);
    let light_mu = clamp(dot(up, to_light), -1.0, 1.0);
    let left = exp(-medium_extinction(air_path_between(atmosphere_shells(), way.start, way.length)));
    let lit = atmosphere_lit(way, left, light_mu, nu, dot(normal, normal), dot(up, direction - nu * to_light));
    if !way.grounded {
        return SkyAir(lit.from_light, lit.from_sky, left);
    }
    var from_ground = vec3f(0.0);
#if sky.multiple_scattering
    let r = sky.ground_radius + way.start.height;
    let ground_mu = clamp((r * light_mu + way.length * nu) / sky.ground_radius, -1.0, 1.0);
    let direct = max(ground_mu, 0.0) * atmosphere_transmittance(0.0, ground_mu);
    from_ground = left * sky.ground_albedo / 3.14159265 * (direct + orders_irradiance(0.0, ground_mu));
#endif
    return SkyAir(lit.from_light, lit.from_sky + from_ground, vec3f(0.0));
}
