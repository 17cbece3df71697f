// Light that the air scatters more than once, without a table: a two-stream field, mended to what path tracing shows.
//
// The field is Eddington's for conservative scattering over a grey ground, in closed form: aerosols count by the part
// that they do not send forward, ozone dims the sun above it all, and a low sun, or one below the horizon, shines
// down a column as many times thicker as its way through curved air is longer than a vertical one. Against the mean
// radiance of traced paths (Earth, sea level to 60 km) that much alone is right within a factor of two as long as the
// sun is up.
//
// The numbers in `orders_field` and `orders_source` are a least squares fit of the sky's whole radiance, weighted
// toward the worst: over 2,300 rays under 20 suns, their light from fields that `truth`'s example `orders` traced,
// and over 225 rays traced singly, at dusk, in hazier air and on Mars. They depend on optical depth, sun and height
// alone, and so follow the parameters of the air. With an exact first order, Earth's sky is right within 3 % for suns
// up to 85° from the zenith, 7 % to 90°, 12 % at 92°, 20 % at 94° and 96°; air of ten times the aerosols
// within 15 % and Mars's within 40 % by day. Those are over ground of albedo .3; over whiter ground a bound keeps
// what comes out at what goes in (`orders_over_white`).

#include <sky/medium.wgsl>

/// The light of all orders but the sun's own at a place, sun irradiance 1.
struct OrdersField {
    /// Mean radiance over all directions.
    mean: vec3f,
    /// Net irradiance downward.
    down: vec3f,
    /// Part of the sunlight that is left here, what aerosols sent forward included.
    sun: vec3f,
    /// Air between here and the sun, in vertical columns of the air above.
    air_mass: f32,
    /// Densities, from `medium_density`.
    density: vec3f,
    /// The sun's height as the fit counts it, -.62 .. 1.
    w: f32,
    /// Logarithm of the air's optical depth, as the fit counts it, -1.5 .. 1.5.
    x: vec3f,
    /// What the fitted mean is to be multiplied by over ground whiter than that of the fit: .5 .. 1.
    over_white: vec3f,
}

/// Columns of air above a point that lie between it and a sun at `sun_mu`, `radius` in scale heights. Schüler's form of
/// Chapman's function; under the horizon it grows slower, as air that the sun no longer reaches is lit from the side.
fn orders_air_mass(radius: f32, sun_mu: f32) -> f32 {
    let level = max(sqrt(1.5707963 * radius), 1.0);
    let direct = level / ((level - 1.0) * abs(sun_mu) + 1.0);
    if sun_mu >= 0.0 {
        return direct;
    }
    let below = radius * sun_mu * sun_mu / (1.0 + sqrt(max(1.0 - sun_mu * sun_mu, 0.0)));
    return 2.0 * level * exp(below / (1.0 + 0.06 * below)) - direct;
}

/// The two-stream field at `height` (m) with the sun's zenith angle at cosine `sun_mu`, before the fit.
fn orders_two_stream(height: f32, sun_mu: f32) -> OrdersField {
    let h = max(height, 0.0);
    let density = medium_density(h);
    let molecules = 1e-6 * sky.rayleigh_height * sky.rayleigh_scattering;
    let aerosols = 1e-6 * (1.0 - sky.mie_asymmetry) * sky.mie_height * sky.mie_scattering;
    let column = max(molecules + aerosols, vec3f(1e-9));
    let above = density.x * molecules + density.y * aerosols;
    let air_mass = orders_air_mass((sky.ground_radius + h) / sky.rayleigh_height, sun_mu);
    let mu = 1.0 / air_mass;
    let here = exp(-above * air_mass);
    let at_ground = exp(-column * air_mass);
    let ozone = 1e-6 * sky.ozone_half_width * sky.ozone_absorption;
    let past_ozone = exp(-2.0 * ozone / (sun_mu + sqrt(sun_mu * sun_mu + 0.016)));
    // Net flux, the same at all heights, from what comes down at the top and goes up at the ground; then the mean.
    let dark = 1.0 - sky.ground_albedo;
    let mirror = 0.5 * (1.0 + sky.ground_albedo);
    let lit = 0.25 * dark * mu * (2.0 + 3.0 * mu * (1.0 - at_ground)) + 0.5 * dark * mu * at_ground;
    let net = lit / (0.25 * dark * (2.0 + 3.0 * column) + mirror);
    let scalar = 2.0 * (mu - net) - 3.0 * net * above + 3.0 * mu * mu * (1.0 - here);
    var field: OrdersField;
    field.mean = max(scalar, vec3f(0.0)) * past_ozone / 12.566371;
    field.down = (net - mu * here) * past_ozone;
    field.sun = here * past_ozone;
    field.air_mass = air_mass;
    field.density = density;
    field.w = max(sun_mu / (abs(sun_mu) + 0.15), -0.62);
    let x = log(column) + 2.2;
    field.x = clamp(x, vec3f(-1.5), vec3f(1.5));
    field.over_white = orders_over_white(h, density.x, x, field.x);
    return field;
}

// Albedo of the ground under the traced paths.
const ORDERS_ALBEDO: f32 = 0.3;

/// What keeps the fit from giving out more light than comes in where the ground is whiter than that of the traced paths.
///
/// Air that absorbs nothing over white ground, in a sky of radiance 1, is known without tracing: it can't be told from
/// that sky. The fit's numbers are the upper envelope, over thin, thick and hazy air, of what was too much then; up high
/// it is what the planet fills less than half of the view. 1 up to `ORDERS_ALBEDO`. `x` and `clamped`: `OrdersField.x`.
fn orders_over_white(height: f32, thick: f32, x: vec3f, clamped: vec3f) -> vec3f {
    let whiter = max(sky.ground_albedo - ORDERS_ALBEDO, vec3f(0.0)) / (1.0 - ORDERS_ALBEDO);
    let dip = min(sqrt(height * (2.0 * sky.ground_radius + height)) / (sky.ground_radius + height), 1.0);
    let high = 0.922 - 0.05 * clamped - 0.025 * clamp(x - 0.9, vec3f(0.0), vec3f(5.0));
    let low = thick * (0.4 + 0.6 * thick) * max(0.09 + clamped * (0.05 * clamped - 0.11), vec3f(0.055));
    return 1.0 - whiter * (1.0 - (1.0 - dip) * min(high - low, vec3f(1.0)));
}

/// What the two-stream field's mean radiance is to be multiplied by: .13 .. 34, and .9 .. 1.8 by day.
fn orders_field(field: OrdersField) -> vec3f {
    let w = field.w;
    let thick = field.density.x;
    var c = vec2f(5.3545, -0.6954);
    c = w * c + vec2f(-13.5216, 4.301) + thick * vec2f(7.7096, 2.1597);
    c = w * c + vec2f(9.222, -5.4584) + thick * vec2f(-11.7752, -5.5033);
    c = w * c + vec2f(-0.2766, 0.9608) + thick * vec2f(3.427, 3.8569);
    c = w * c + vec2f(-0.8533, 0.6854) + thick * (vec2f(-0.7128, 0.9543) + thick * vec2f(1.4853, -0.0892));
    c = w * c + vec2f(-0.6884, 0.0963) + thick * (vec2f(1.9935, -0.3203) + thick * vec2f(-1.4004, -0.6269));
    c = w * c + vec2f(0.5268, 0.0663) + thick * (vec2f(-0.2705, -0.5888) + thick * vec2f(-0.0004, 0.1943));
    return exp(clamp(c.x + c.y * field.x, vec3f(-2.0), vec3f(3.5)));
}

/// Sunlight that aerosols have sent forward, and that the two-stream field still counts as the sun's own.
fn orders_sent_forward(field: OrdersField) -> vec3f {
    let hazy = 1e-6 * sky.mie_height * sky.mie_scattering * field.density.y * field.air_mass;
    return field.sun * (1.0 - exp(-abs(sky.mie_asymmetry) * hazy));
}

/// Radiance scattered per metre (1/m) toward the eye by the air at `height` (m above sea level), out of light that was
/// scattered, or thrown back by the ground, at least once before; sun irradiance 1. `sun_mu` and `view_mu` are cosines
/// of the zenith angles of the sun and of the direction in which the eye looks, there; `cos_theta` that of the angle
/// between them. At least 0, finite.
fn orders_source(height: f32, sun_mu: f32, view_mu: f32, cos_theta: f32) -> vec3f {
    let field = orders_two_stream(height, sun_mu);
    let mean = orders_field(field) * field.over_white * field.mean;
    // Molecules: nearly all ways alike, somewhat more along the horizon, which is the brightest.
    let level = 1.0 - 3.0 * view_mu * view_mu;
    let molecules = 1.0 + (0.0337 + 0.0023 * field.x) * level;
    // Aerosols see what is ahead: the horizon, the brighter half of up and down, the glow after sunset, and sunlight
    // that aerosols have sent forward before, in a lobe of twice the width.
    let tilt = clamp(3.0 * field.down / max(12.566371 * field.mean, vec3f(1e-30)), vec3f(-1.5), vec3f(1.5));
    let g = sky.mie_asymmetry * sky.mie_asymmetry;
    let lobe = (1.0 - g * g) / pow(1.0 + g * g - 2.0 * g * clamp(cos_theta, -1.0, 1.0), 1.5);
    let horizon = 0.3 / (0.3 + abs(view_mu));
    let night = (1.0 - field.w) * (1.0 - field.w);
    let ahead = 0.0875 + 0.3791 * tilt * view_mu + (0.9527 + 0.4691 * field.x) * horizon
        + (0.1513 - 0.1636 * field.x) * night * (lobe - 1.0);
    let sent = orders_sent_forward(field) / 12.566371;
    let aerosols = mean * max(ahead, vec3f(0.0)) + exp(-0.5216 + 0.3034 * field.x) * lobe * sent;
    return 1e-6 * (field.density.x * sky.rayleigh_scattering * (mean * molecules + sent)
        + field.density.y * sky.mie_scattering * aerosols);
}

/// Irradiance of a level surface at `height` (m above sea level) by the whole sky above it, first order included,
/// without the sun itself; sun irradiance 1. At least 0, finite.
fn orders_irradiance(height: f32, sun_mu: f32) -> vec3f {
    let field = orders_two_stream(height, sun_mu);
    let half = 3.1415927 * field.mean + 0.5 * field.down + max(sun_mu, 0.0) * orders_sent_forward(field);
    let w = field.w;
    let thick = field.density.x;
    let even = 0.2208 + w * (-0.0148 + w * (-2.3921 + w * (4.8936 + w * -2.7729)));
    let low = -0.0552 + w * (-0.2602 + w * 0.3754);
    let thicker = 0.137 + w * (-0.3933 + w * (-0.0425 + w * (1.4438 + w * -1.197)));
    let low_thicker = -0.0689 + w * 0.0219;
    let edge = 0.0036 / (0.0036 + sun_mu * sun_mu);
    let part = even + thick * low - 0.276 * edge + (thicker + thick * low_thicker - 0.1123 * edge) * field.x;
    return max(half, vec3f(0.0)) * exp(clamp(part, vec3f(-2.0), vec3f(0.5)));
}
