// How a point inside of a cloud is lit: by the sun, all orders of scattering, by the sky above and the ground below.
//
// A source S is the radiance that a ray toward the eye gains per unit of optical depth: a step through `d` of it adds
// transmittance * S * (1 - exp(-d)). All depths are optical, 0 or more; cosines of elevations are positive upward.
#include <light/phase.wgsl>

/// What a cloud scatters with: two lobes of Henyey & Greenstein's.
struct CloudMedium {
    /// Anisotropy of the forward lobe, 0 .. .95.
    g_forward: f32,
    /// Anisotropy of the back lobe, -.95 .. 0.
    g_back: f32,
    /// Part of the scattered light that the forward lobe gets, 0 .. 1.
    forward_share: f32,
    /// Part of the light that is scattered and not absorbed, 0 .. 1: 1 for water droplets.
    albedo: f32,
}

/// Light of the sun scattered once toward the eye, exact: Beer's law times the phase function. For a sun of irradiance 1.
///
/// `cos_theta`: cosine between the ray from the eye and the direction to the sun; `sun_depth`: from the point to the sun.
fn cloud_source_single(cos_theta: f32, sun_depth: f32, medium: CloudMedium) -> f32 {
    return medium.albedo * exp(-max(sun_depth, 0.0)) * cloud_lobes(cos_theta, 1.0, medium);
}

/// Light of the sun scattered any number of times, for a sun of irradiance 1: the first order exactly, what was turned
/// little as a wider beam, the rest as a two-stream field (Eddington 1916; with the peak of the phase function taken as
/// unscattered: Joseph, Wiscombe & Weinman 1976).
///
/// `cos_theta`: between the ray from the eye and the direction to the sun; `sun_mu`, `view_mu`: cosines of the zenith
/// angles of the sun and of the ray. Depths from the point: `sun_depth` to the sun, `depth_above` straight up,
/// `depth_below` straight down. Where the sun is nearer than it would be in a level layer, as in the flank of a heap, the
/// layer is taken as turned toward it, and as no thinner for that. `cover`: part of the sky that such clouds cover, 0 .. 1;
/// the less it is, the more light leaves through flanks on its way. >= 0.
///
/// In layers of g .8 and -.3 (share .85) and albedo 1 of thickness .5 .. 64, for suns 0 .. 80 degrees from the zenith and
/// views of 0 .. 80, within 25 % of the path-traced radiance (10 % in the mean). What leaves a layer is no more than what
/// came in; of heaps, whose depths are marched toward the sun and estimated above and below, it is .8 .. 1 of that.
fn cloud_source(
    cos_theta: f32,
    sun_mu: f32,
    view_mu: f32,
    sun_depth: f32,
    depth_above: f32,
    depth_below: f32,
    cover: f32,
    medium: CloudMedium,
) -> f32 {
    let to_sun = clamp(sun_depth, 0.0, 1e6);
    let up = smoothstep(-0.02, 0.02, sun_mu); // 0: the sun shines from below
    let lit = clamp(mix(depth_below, depth_above, up), 0.0, 1e6);
    let far = clamp(mix(depth_above, depth_below, up), 0.0, 1e6);

    // The layer: cosine of the sun's angle to its normal, and of the ray's.
    let level_mu = clamp(abs(sun_mu), 0.03, 1.0);
    let mu = clamp(lit / max(to_sun, 1e-5), level_mu, 1.0);
    let turned = (mu - level_mu) / max(1.0 - level_mu, 1e-3);
    let ray_mu = mix(view_mu * (2.0 * up - 1.0), cos_theta, turned);

    // Delta scaling: the part `peak` of what is scattered goes on as if it was not.
    let mean = mix(medium.g_back, medium.g_forward, medium.forward_share);
    let peak = mix(medium.g_back * medium.g_back, medium.g_forward * medium.g_forward, medium.forward_share);
    let albedo = min(medium.albedo, 0.999999);
    let scale = 1.0 - albedo * peak;
    let depth = to_sun * mu * scale;
    // Turned, it is as thick as it is level.
    let rest = mix(far, max(far, lit + far - to_sun * mu), turned) * scale;
    let field = cloud_field(depth, rest, mu, (1.0 - peak) * albedo / scale, (mean - peak) / (1.0 - peak));

    // Numbers below are fitted to path-traced layers. Two streams know nothing of rays and beams that graze the layer.
    let slant = 1.0 - mu;
    let graze = 1.0 - min(abs(ray_mu), 1.0);
    let side = 1.0 + graze * exp(-0.17 * depth) * (0.29 * slant + 0.37 * exp(-0.17 * rest));
    let share = (1.0 - 0.27 * slant * slant * slant) * (1.0 - 0.17 * max(mean, 0.0)) * side;
    let kept = cloud_kept(turned, level_mu, depth, cover);
    let diffuse = max(field.x + mean * field.y * ray_mu, 0.0) * share * kept;

    // Turned little: a beam that is less slanted than the sun's, with the lobe of two turns; where both the beam and the
    // ray graze the layer it comes back out of the cloud, too.
    let beam_mu2 = mu * mu + 0.024 * (1.0 - mu * mu);
    let returns = 2.3 * max(mean, 0.0) * slant * graze * (1.0 - exp(-4.0 * (depth + rest)));
    let early = 1.0 - exp(-albedo * peak * to_sun) * (1.0 - returns);
    let beam = exp(-depth * inverseSqrt(beam_mu2)) * mu * mu / beam_mu2 * early;

    let once = exp(-to_sun) * cloud_lobes(cos_theta, 1.0, medium);
    return medium.albedo * (once + beam * cloud_lobes(cos_theta, medium.g_forward, medium) + diffuse);
}

/// Part of the diffuse light that stays where a level layer would have it, 0 .. 1; in a level layer all of it.
///
/// What flanks turned to the sun get, others behind them lack: the more so the lower the sun and the closer the layer.
/// And heaps lose through their flanks what went deep. The numbers balance what leaves the layers of the presets and of
/// <clouds/layer.wgsl>, by rays in all directions, with what came in, for suns 8 .. 70 degrees high.
fn cloud_kept(turned: f32, level_mu: f32, depth: f32, cover: f32) -> f32 {
    let shaded = 1.0 - turned * cover * min(0.13 + 0.125 / level_mu, 0.78);
    let deep = 1.0 - exp(-depth);
    return shaded * (1.0 - (1.0 - cover) * (0.4 + 0.6 * level_mu) * deep);
}

/// The same by octaves (Wrenninge et al. 2013): each next one has half the extinction, half the intensity and half the
/// anisotropy, and what leaves the cloud at once is no longer there for it. Needs no level layer. What leaves is no more
/// than what came in, but the middle of the layers of `cloud_source` gets a fifth of its light. `octaves`: 1 .. 8.
fn cloud_source_octaves(
    cos_theta: f32,
    sun_depth: f32,
    depth_above: f32,
    depth_below: f32,
    octaves: i32,
    medium: CloudMedium,
) -> f32 {
    let stays = medium.albedo * (1.0 - 0.5 * (exp(-max(depth_above, 0.0)) + exp(-max(depth_below, 0.0))));
    var sum = 0.0;
    var half = 1.0;
    var part = medium.albedo;
    for (var i = 0; i < min(octaves, 8); i++) {
        let lobes = phase_two_lobe(cos_theta, medium.g_forward * half, medium.g_back * half, medium.forward_share);
        sum += part * exp(-max(sun_depth, 0.0) * half) * lobes;
        half *= 0.5;
        part *= 0.5 * stays;
    }
    return sum;
}

/// How much of the radiance of a sky above (x) and of a ground below (y), each the same in all directions, is scattered
/// toward the eye: the source is x * sky + y * ground (two streams, Eddington).
///
/// For albedo 1, x + y = 1 to rounding at any depth and for any ray: in a white furnace a cloud vanishes.
fn cloud_ambient_source(view_mu: f32, depth_above: f32, depth_below: f32, medium: CloudMedium) -> vec2f {
    let above = clamp(depth_above, 0.0, 1e6);
    let below = clamp(depth_below, 0.0, 1e6);
    let mean = mix(medium.g_back, medium.g_forward, medium.forward_share);
    let along = clamp(mean, -0.66, 0.66) * view_mu;
    if medium.albedo >= 0.999999 {
        let flux = 1.0 / (4.0 / 3.0 + (1.0 - mean) * (above + below));
        let from_sky = (2.0 / 3.0 + along + (1.0 - mean) * below) * flux;
        return vec2f(from_sky, 1.0 - from_sky);
    }
    // Falls off as sinh and cosh; everything over exp(rate (above + below)), so that nothing overflows.
    let rate = sqrt(3.0 * (1.0 - medium.albedo) * (1.0 - medium.albedo * mean));
    let edge = 2.0 / 3.0 * rate / (1.0 - medium.albedo * mean);
    let near = exp(-rate * vec2f(above, below));
    let past = near.yx * near.yx;
    let both = past.x * past.y;
    let norm = (1.0 + edge * edge) * (1.0 - both) + 2.0 * edge * (1.0 + both);
    let level = near * ((1.0 - past) + edge * (1.0 + past));
    let slope = 1.5 * edge * near * ((1.0 + past) + edge * (1.0 - past));
    return medium.albedo * max(level + along * slope * vec2f(1.0, -1.0), vec2f(0.0)) / norm;
}

/// "Powder" (Schneider 2015): edges toward the sun get darker, as if light had to be gathered first. A factor 0 .. 1 for
/// `cloud_source_single` and the octaves; the two streams need none.
fn cloud_powder(sun_depth: f32) -> f32 {
    return 1.0 - exp(-2.0 * max(sun_depth, 0.0));
}

/// A phase function with a silver lining: `share` (0 .. 1) of `phase` goes into a narrow lobe around the sun instead,
/// `spread` (.01 .. .5) wide. Whole if `phase` is whole.
fn cloud_silver_lining(cos_theta: f32, phase: f32, share: f32, spread: f32) -> f32 {
    return mix(phase, phase_henyey_greenstein(cos_theta, 1.0 - spread), share);
}

/// The medium's phase function, of light that was turned before: both lobes' anisotropies times `before` (1: first turn).
fn cloud_lobes(cos_theta: f32, before: f32, medium: CloudMedium) -> f32 {
    return phase_two_lobe(cos_theta, medium.g_forward * before, medium.g_back * before, medium.forward_share);
}

/// The diffuse field at `depth` below the top of a layer with `rest` of it below, in scaled numbers: mean radiance and the
/// slope of the radiance along the way down. Eddington's approximation, for a beam of cosine `mu` and irradiance 1 facing
/// it; dark above and below.
fn cloud_field(depth: f32, rest: f32, mu: f32, albedo: f32, g: f32) -> vec2f {
    let lost = 1.0 - albedo;
    let kept = 1.0 - albedo * g;
    let rate = sqrt(3.0 * lost * kept);
    let slant = select(mu, 0.99 / rate, abs(1.0 - rate * mu) < 0.01); // off the resonance
    let driven = 0.2387324 * albedo / (1.0 - rate * rate * slant * slant); // 3 / 4 pi
    let level = driven * slant * slant * (1.0 + g * lost);
    let slope = driven * slant * (1.0 + 3.0 * g * lost * slant * slant);
    let ratio = sqrt(3.0 * lost / kept);
    let outer = 1.0 + 2.0 / 3.0 * ratio;
    let inner = 1.0 - 2.0 / 3.0 * ratio;

    let fall = exp(-rate * depth);
    let rise = exp(-rate * rest);
    let beam = exp(-depth / slant);
    let whole = fall * rise * inner;
    let top = level + 2.0 / 3.0 * slope;
    let bottom = beam * exp(-rest / slant) * (level - 2.0 / 3.0 * slope);
    let norm = 1.0 / (outer * outer - whole * whole);
    let down = (top * outer - bottom * whole) * norm * fall;
    let back = (bottom * outer - top * whole) * norm * rise;
    return vec2f(down + back - level * beam, ratio * (down - back) - slope * beam);
}
