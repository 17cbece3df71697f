// A layer of clouds: where it lies, what it is made of, how it drifts.

#include <clouds/forms.wgsl>
#include <frame.wgsl>
#include <geometry/globe.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <light/cloud.wgsl>
#include <noise/perlin.wgsl>
#include <noise/puffs.wgsl>
#include <quality.wgsl>
#include <sky/medium.wgsl>
#include <sun/key.wgsl>

#include <fractal/fbm3.wgsl> as cloud_sheet with noise3 = perlin_noise3_grad
#include <march/volume.wgsl> as cloud_volume with density = cloud_extinction, vacancy = cloud_vacancy, span = cloud_ahead, source = cloud_lit

/// What shapes the clouds: `weather` cover and type that vary over the land, heaps with flat bases and billowing tops;
/// `plain` a sheet of fBm; `boxed` puffs inside of a box.
#option clouds.form = weather { plain, weather, boxed }
/// Between two planes, or between two spheres around the planet (for views from high up).
#option clouds.shape = slab { slab, shell }
/// Height of the layer's lower side above sea level.
#param clouds.base: f32 = 1100.0, range -5000 .. 100000, unit m
/// Height of the layer's upper side above its lower side: that of the tallest cumulus.
#param clouds.thickness: f32 = 1600.0, range 1 .. 50000, unit m
/// How much of the land has clouds above it.
#param clouds.coverage: f32 = 0.42, range 0 .. 1
/// 0 stratus, in the lowest third of the layer; 0.5 stratocumulus; 1 cumulus, as high as the layer.
#param clouds.type: f32 = 1.0, range 0 .. 1
/// How far the type and the cover vary from region to region.
#param clouds.variety: f32 = 0.3, range 0 .. 1
/// How distinct clouds are: at 2 separate heaps, at 0.3 one ragged sheet.
#param clouds.clumping: f32 = 0.55, range 0.2 .. 3
/// Distance from one heap to the next.
#param clouds.scale: f32 = 2600.0, range 10 .. 10000000, log, unit m
/// How much smaller heaps are toward their tops.
#param clouds.taper: f32 = 0.5, range 0 .. 1
/// How deep the smallest puffs and wisps are cut into the edges.
#param clouds.detail: f32 = 0.35, range 0 .. 0.9
/// How gently clouds begin: small is a crisp edge.
#param clouds.softness: f32 = 0.12, range 0.01 .. 1
/// Extinction in the densest parts: how much light a metre takes.
#param clouds.extinction: f32 = 0.08, range 0.00001 .. 10, log, unit 1/m
/// Which clouds: another seed, another sky.
#param clouds.seed: u32 = 1
/// Where the wind blows to, clockwise from north.
#param clouds.wind_heading: f32 = 70.0, range -360 .. 360, unit deg
/// How fast it blows.
#param clouds.wind_speed: f32 = 8.0, range 0 .. 200, unit m/s
/// How far the wind carries the tops ahead of the bases, for each metre of height.
#param clouds.shear: f32 = 0.15, range -2 .. 2
/// How fast the puffs rise.
#param clouds.rise: f32 = 1.5, range -50 .. 50, unit m/s
/// Middle of the box, east and south of the origin (`clouds.form` = `boxed`).
#param clouds.box_center: vec2f = (0, 0), unit m
/// Size of the box from west to east and from north to south.
#param clouds.box_size: vec2f = (4000, 4000), range 1 .. 1000000, unit m

/// How often light is scattered on its way: once; in octaves that each reach deeper; any number of times, by a
/// two-stream field fitted to path-traced clouds.
#option clouds.scattering = many { once, octaves, many }
/// Part of the light that droplets scatter and do not absorb.
#param clouds.albedo: f32 = 1.0, range 0 .. 1
/// Droplets scatter into two lobes: mean cosine of the forward one.
#param clouds.forward: f32 = 0.8, range 0 .. 0.95
/// Mean cosine of the lobe back toward the light.
#param clouds.back: f32 = -0.3, range -0.95 .. 0
/// Part of the light that the forward lobe gets.
#param clouds.forward_share: f32 = 0.85, range 0 .. 1
/// How far sunlight gets into clouds: 1 as the extinction has it, 2 twice as far, for the look: they then give out more
/// light than falls on them.
#param clouds.penetration: f32 = 1.0, range 0.1 .. 10, log
/// Part of the light that goes on nearly straight: thin edges before the sun shine.
#param clouds.silver_lining: f32 = 0.15, range 0 .. 1
/// How wide the shine around the sun is.
#param clouds.silver_spread: f32 = 0.06, range 0.01 .. 0.5
/// How much darker edges toward the sun are than what is behind them ("powder"). Not physical with `scattering` =
/// `many`.
#param clouds.powder: f32 = 0.0, range 0 .. 1
/// As far as clouds are looked for from where a ray comes into the layer.
#param clouds.far: f32 = 120000.0, range 100 .. 100000000, log, unit m
/// Colour of the land or sea beneath: the light that it throws back lights the bases.
#param clouds.ground: vec3f = (0.10, 0.11, 0.09), color

// What of the cover a heap keeps to its edge, where `weather` puts the border of clouds.
const CLOUD_BRINK: f32 = 0.28;
// The second octave of heaps over the first, in strength and in frequency.
const CLOUD_GAIN: f32 = 0.4;
const CLOUD_LACUNARITY: f32 = 2.3;
// Regions are this many times as wide as heaps, and their noise this strong.
const CLOUD_REGION: f32 = 6.0;
const CLOUD_REGION_GAIN: f32 = 0.6;
// Puffs: octaves of the clouds' shape, octaves of their edges.
const CLOUD_SHAPE_OCTAVES: i32 = 3;
const CLOUD_OCTAVES: i32 = 5;
// What the noise that clouds are cut out of is on average.
const CLOUD_MEAN: f32 = 0.84;
// As far as it is worth telling that there is no cloud, in distances between heaps.
const CLOUD_VACANT: f32 = 0.3;
// Samples of a column's profile; steps that a shadow's way is divided into; width of the smallest detail looked at, in pixels.
#if quality == low
const CLOUD_COLUMN: i32 = 3;
const CLOUD_SHADOW_SAMPLES: i32 = 4;
const CLOUD_DETAIL: f32 = 4.0;
const CLOUD_CERTAIN: i32 = 4; // halvings by which it is found out how far there is no cloud
#elif quality == medium
const CLOUD_COLUMN: i32 = 8;
const CLOUD_SHADOW_SAMPLES: i32 = 32;
const CLOUD_DETAIL: f32 = 1.0;
const CLOUD_CERTAIN: i32 = 7;
#elif quality == high
const CLOUD_COLUMN: i32 = 8;
const CLOUD_SHADOW_SAMPLES: i32 = 64;
const CLOUD_DETAIL: f32 = 1.0;
const CLOUD_CERTAIN: i32 = 7;
#else
const CLOUD_COLUMN: i32 = 8;
const CLOUD_SHADOW_SAMPLES: i32 = 96;
const CLOUD_DETAIL: f32 = 1.0;
const CLOUD_CERTAIN: i32 = 7;
#endif
// The least that is eaten, over the most.
const CLOUD_RIM: f32 = 0.35;
// How deep `clouds.detail` = 1 eats, in units of the density before `clouds.softness`.
const CLOUD_BITE: f32 = 0.5;
// Water in the air at the bottom of a cloud over that at its top.
const CLOUD_BASE_DENSITY: f32 = 0.6;
// The plain sheet: its strength against the noise, the mean of what it adds, the octaves of noise, the spread of both.
const CLOUD_SHEET: f32 = 0.6;
const CLOUD_SHEET_MEAN: f32 = 1.0;
const CLOUD_SHEET_OCTAVES: f32 = 4.0;
const CLOUD_SHEET_GAIN: f32 = 0.5;
const CLOUD_SHEET_SPREAD: f32 = 0.3;
// Width of the largest puffs over that of the heaps.
const CLOUD_PUFF: f32 = 0.2;
// How far the slope of the Perlin noise displaces puffs, in their widths.
const CLOUD_WARP: f32 = 0.14;
// Rotation of one octave of puffs against the one before: rows (-2, -3, -6)/7, (-3, 6, -2)/7, (6, 2, -3)/7.
const CLOUD_TURN: mat3x3f = mat3x3f(
    vec3f(-0.28571429, -0.42857143, 0.85714286),
    vec3f(-0.42857143, 0.85714286, 0.28571429),
    vec3f(-0.85714286, -0.28571429, -0.42857143),
);

/// Height of `p` above sea level (m): above the sphere of radius `sky.ground_radius` or, of a slab, above y = 0.
fn cloud_altitude(p: vec3f) -> f32 {
#if clouds.shape == shell
    return globe_height(p, sky.ground_radius);
#else
    return p.y;
#endif
}

/// Unit vector upward at `p` (m).
fn cloud_up(p: vec3f) -> vec3f {
#if clouds.shape == shell
    return globe_up(p, sky.ground_radius);
#else
    return vec3f(0.0, 1.0, 0.0);
#endif
}

/// How high `p` (m) is in the layer: 0 at its lower, 1 at its upper side, less and more outside.
fn cloud_height_fraction(p: vec3f) -> f32 {
    return (cloud_altitude(p) - clouds.base) / clouds.thickness;
}

/// The part of a ray's line that can meet the layer.
///
/// Of a shell: from below its upper half, from inside and from above, also from space, all between where the line
/// enters the outer sphere and where it leaves it or goes down to the planet's ground; `cloud_vacancy` leads over the
/// gap below the layer, if there is one.
fn cloud_span(origin: vec3f, direction: vec3f) -> RaySpan {
    let low = clouds.base;
    let high = clouds.base + clouds.thickness * cloud_end();
#if clouds.shape == shell
    let outer = globe_span(origin, direction, sky.ground_radius, high);
    let inner = globe_span(origin, direction, sky.ground_radius, low);
    if outer.near > outer.far || inner.near > inner.far {
        return outer;
    }
    if cloud_altitude(origin) < low {
        return RaySpan(inner.far, outer.far);
    }
    let is_ground_ahead = ray_meets(globe_span(origin, direction, sky.ground_radius, min(0.0, low)));
    return RaySpan(outer.near, select(outer.far, inner.near, is_ground_ahead));
#else
    let span = ray_slab(origin.y, direction.y, low, high);
#if clouds.form == boxed
    let half = 0.5 * clouds.box_size;
    let east = ray_slab(origin.x, direction.x, clouds.box_center.x - half.x, clouds.box_center.x + half.x);
    let south = ray_slab(origin.z, direction.z, clouds.box_center.y - half.y, clouds.box_center.y + half.y);
    return ray_both(span, ray_both(east, south));
#else
    return span;
#endif
#endif
}

/// How far the wind has carried the clouds, and the shear what is `above` (m) the layer's base, in the plane (m).
fn cloud_drift(above: f32) -> vec2f {
    let heading = vec2f(sin(clouds.wind_heading), -cos(clouds.wind_heading));
    return (clouds.wind_speed * frame.time + clouds.shear * above) * heading;
}

/// Standard score that is exceeded with probability `share`, near enough: -6.3 .. 6.3.
fn cloud_score(share: f32) -> f32 {
    return 0.5513 * log((1.0 - share + 1e-5) / (share + 1e-5));
}

#if clouds.form == weather

/// What the weather makes of a place.
struct CloudWeather {
    /// How much of the base noise becomes cloud: none from 0 down, all from 1 on.
    cover: f32,
    /// How far over land `cover` surely stays below 0 (m).
    clear: f32,
    /// See `clouds.type`.
    kind: f32,
    /// How fast `cover` can rise over land (1/m): anywhere, and here; and how fast the latter can grow (1/m²).
    rise: vec3f,
}

/// The weather at `p` (m), which is `above` (m) the layer's base.
fn cloud_weather(p: vec3f, above: f32) -> CloudWeather {
    let frequency = 1.0 / clouds.scale;
    let drift = cloud_drift(above);
    let region_gain = CLOUD_REGION_GAIN * clouds.variety;
    let spread = sqrt((1.0 + CLOUD_GAIN * CLOUD_GAIN) + region_gain * region_gain);
    // Bounds over all places: the first and the second derivative along any line.
    let slope = 1.0 + CLOUD_GAIN * CLOUD_LACUNARITY + region_gain / CLOUD_REGION;
#if clouds.shape == shell
    // On the planet's surface beneath: p less its height.
    let up = cloud_up(p);
    let place = (p - cloud_altitude(p) * up - vec3f(drift.x, 0.0, drift.y)) * frequency;
    let heaps = perlin_noise3(place, clouds.seed);
    let knots = perlin_noise3(CLOUD_LACUNARITY * (CLOUD_TURN * place) + 17.3, clouds.seed + 1u);
    let region = perlin_noise3(place / CLOUD_REGION + 5.7, clouds.seed + 2u);
    let sum = heaps + CLOUD_GAIN * knots + region_gain * region;
    let threshold = 0.26 * spread * cloud_score(clouds.coverage);
    let lack = threshold - CLOUD_BRINK / clouds.clumping - sum;
    let clear = lack / (PERLIN_NOISE3_SLOPE * slope);
    let rise = vec3f(vec2f(PERLIN_NOISE3_SLOPE * slope * frequency), 0.0);
#else
    let place = (p.xz - drift) * frequency;
    let heaps = perlin_noise2_grad(place, clouds.seed);
    let turned = vec2f(0.8 * place.x - 0.6 * place.y, 0.6 * place.x + 0.8 * place.y);
    let knots = perlin_noise2_grad(CLOUD_LACUNARITY * turned + 17.3, clouds.seed + 1u);
    let region = perlin_noise2_grad(place / CLOUD_REGION + 5.7, clouds.seed + 2u);
    let turned_back = vec2f(0.8 * knots.y + 0.6 * knots.z, -0.6 * knots.y + 0.8 * knots.z);
    let gradient = heaps.yz + CLOUD_GAIN * CLOUD_LACUNARITY * turned_back + region_gain / CLOUD_REGION * region.yz;
    let sum = heaps.x + CLOUD_GAIN * knots.x + region_gain * region.x;
    let threshold = 0.304 * spread * cloud_score(clouds.coverage);
    // The sum is below threshold - brink for as long as its rise, at most steepness · s + curvature / 2 · s², lacks.
    let lack = threshold - CLOUD_BRINK / clouds.clumping - sum;
    let bend = CLOUD_GAIN * CLOUD_LACUNARITY * CLOUD_LACUNARITY + region_gain / (CLOUD_REGION * CLOUD_REGION);
    let curvature = PERLIN_NOISE2_CURVATURE * (1.0 + bend);
    let steepness = length(gradient);
    let root = sqrt(max(steepness * steepness + 2.0 * curvature * lack, 0.0));
    let clear = max(lack / (PERLIN_NOISE2_SLOPE * slope), 2.0 * lack / (steepness + root + 1e-9));
    let rise = vec3f(PERLIN_NOISE2_SLOPE * slope, steepness, curvature * frequency) * frequency;
#endif
#if clouds.shape == shell
    let regional = region;
#else
    let regional = region.x;
#endif
    let cover = CLOUD_BRINK + clouds.clumping * (sum - threshold);
    let kind = clamp(clouds.type + 0.8 * clouds.variety * regional, 0.0, 1.0);
    return CloudWeather(cover, max(clear, 0.0) * clouds.scale, kind, clouds.clumping * rise);
}

/// The fraction of the layer above which there is no cloud anywhere.
fn cloud_end() -> f32 {
    return cloud_stops(min(clouds.type + 0.8 * clouds.variety, 1.0)).w;
}

#else

/// The fraction of the layer above which there is no cloud anywhere: all of it may hold some.
fn cloud_end() -> f32 {
    return 1.0;
}

#endif

#if clouds.form == plain

/// The sheet before noise is added: highest in the middle of the layer, above 0 where cloud is likely.
fn cloud_sheet(height: f32) -> f32 {
    let slopes = CLOUD_SHEET * (1.0 - abs(2.0 * height - 1.0) - CLOUD_SHEET_MEAN);
    return slopes - CLOUD_SHEET_SPREAD * cloud_score(clouds.coverage);
}

#endif

/// How far from `p` (m) on there surely is no cloud, in every direction; 0 where there may be one.
///
/// A certificate for marches: above and below the layer the distance to it; of `weather`, what the noise in the plane
/// can't rise in, in the gaps and above, below and between the heaps. Costs three noises in the plane.
fn cloud_vacancy(p: vec3f) -> f32 {
    let altitude = cloud_altitude(p);
    let low = clouds.base;
    let high = clouds.base + clouds.thickness * cloud_end();
    var clear = max(low - altitude, altitude - high);
#if clouds.form == boxed
    let beyond = abs(p.xz - clouds.box_center) - 0.5 * clouds.box_size;
    clear = max(clear, max(beyond.x, beyond.y));
#elif clouds.form == weather
    let weather = cloud_weather(p, altitude - clouds.base);
#if clouds.shape == shell
    // What is carried up to the sphere's surface moves apart on the way.
    let spread = clamp(1.0 + min(altitude, low) / sky.ground_radius, 0.0, 1.0) / (1.0 + abs(clouds.shear));
#else
    let spread = inverseSqrt(1.0 + clouds.shear * clouds.shear);
#endif
    clear = max(clear, spread * weather.clear);
    // Over, under and beside the heaps: as far as profile and cover surely do not add up to what is eaten everywhere.
    let stops = cloud_stops(weather.kind);
    let height = (altitude - clouds.base) / clouds.thickness;
    let least = 1.0 + CLOUD_BITE * CLOUD_RIM * clouds.detail;
    let turning = 0.8 * clouds.variety * PERLIN_NOISE3_SLOPE / (CLOUD_REGION * clouds.scale); // of the type, 1/m
    var free = clear;
    var taken = max(clear, CLOUD_VACANT * clouds.scale);
    for (var i = 0; i < CLOUD_CERTAIN; i++) {
        let way = 0.5 * (free + taken);
        let over_land = way / spread;
        let cover = weather.cover + over_land * min(weather.rise.x, weather.rise.y + 0.5 * weather.rise.z * over_land);
        // A change of the type moves no stop by more than .75 of it.
        let reach = way / clouds.thickness + 0.75 * turning * over_land;
        let lowest = max(height - reach, 0.0);
        let profile = cloud_gradient(clamp(0.5 * (stops.y + stops.z), height - reach, height + reach), stops);
        if profile + min(cover - clouds.taper * lowest * lowest, 1.0) < least {
            free = way;
        } else {
            taken = way;
        }
    }
    clear = free;
#endif
    // Where rounding could tell otherwise, a little less.
    return max(0.999 * clear - 1e-6 * (abs(altitude) + abs(high)), 0.0);
}

/// Relative density of the clouds at `p` (m), 0 .. 1, in full detail: `clouds.extinction` times it is the extinction.
///
/// `weather`: three noises in the plane; where these leave clouds, one in space and three of puffs; where these do, two
/// more of puffs.
fn cloud_density(p: vec3f) -> f32 {
    return cloud_density_filtered(p, 0.0);
}

/// As `cloud_density`, without puffs that a pixel `footprint` (m) wide can't show: they fade to their mean. Cheaper.
fn cloud_density_filtered(p: vec3f, footprint: f32) -> f32 {
    let height = cloud_height_fraction(p);
    if height <= 0.0 || height >= 1.0 {
        return 0.0;
    }
    let drift = cloud_drift(height * clouds.thickness);
    let carried = p - vec3f(drift.x, clouds.rise * frame.time, drift.y);
#if clouds.form == plain
    let octaves = clamp(log2(0.5 * clouds.scale / max(footprint, 1e-3)), 1.0, CLOUD_SHEET_OCTAVES);
    let noise = cloud_sheet_fbm3(carried / clouds.scale, clouds.seed, octaves, CLOUD_SHEET_GAIN, 2.0).x;
    return clamp((cloud_sheet(height) + noise) / clouds.softness, 0.0, 1.0);
#else
#if clouds.form == weather
    let weather = cloud_weather(p, height * clouds.thickness);
    let profile = cloud_gradient(height, cloud_stops(weather.kind));
    let cover = weather.cover - clouds.taper * height * height;
    if profile + min(cover, 1.0) < 1.0 + CLOUD_BITE * CLOUD_RIM * clouds.detail {
        return 0.0; // whatever the noise: all of it would be eaten
    }
#else
    let room = 0.5 * clouds.box_size - abs(p.xz - clouds.box_center);
    let inset = min(room.x, room.y) / (0.2 * min(clouds.box_size.x, clouds.box_size.y));
    let profile = clamp(min(inset, min(8.0 * height, 4.0 - 4.0 * height)), 0.0, 1.0);
    let cover = clouds.coverage;
#endif
    if cover <= 0.0 || profile <= 0.0 {
        return 0.0;
    }

    // Perlin noise lifts the largest puffs, three octaves of puffs fill it, two more eat its edges.
    let lift = perlin_noise3_grad(carried * (1.7 / clouds.scale), clouds.seed + 3u);
    let perlin = 0.5 + 0.5 * lift.x;
    // Its slope pulls puffs together here and apart there: they are not all of one size, nor in rows.
    var place = CLOUD_TURN * carried / (CLOUD_PUFF * clouds.scale) + CLOUD_WARP * lift.yzw;
    var width = CLOUD_PUFF * clouds.scale;
    var weight = 0.625;
    var puffs = 0.0;
    var finer = 0.0; // the same fBm from the second octave on
    var density = 0.0;
    var detail = 0.0;
    for (var i = 0; i < CLOUD_OCTAVES; i++) {
        if i == CLOUD_SHAPE_OCTAVES {
#if clouds.form == weather
            density = cloud_cover(profile * cloud_lift(mix(perlin, 1.0, puffs), 1.0 - finer), min(cover, 1.0));
#else
            density = cloud_cover(profile * 2.0 * perlin * puffs, cover);
#endif
            if density <= 0.0 {
                return 0.0;
            }
            weight = 0.65;
        }
        let presence = clamp(2.0 - 4.0 * footprint / width, 0.0, 1.0);
        var puff = PUFF_NOISE3_MEAN;
        if presence > 0.0 {
            puff = mix(puff, puff_noise3(place, clouds.seed + 4u + u32(i)), presence);
        }
        if i < CLOUD_SHAPE_OCTAVES {
            puffs += weight * puff;
            finer += select(2.5 * weight, 0.0, i == 0) * puff;
            weight = select(0.125, 0.25, i == 0);
        } else {
            detail += weight * puff;
            weight = 0.35;
        }
        width *= 0.5;
        place = 2.0 * (CLOUD_TURN * place) + 31.7;
    }
    // Thin rims go altogether, or crumbs would be left in the middles of puffs.
    let bite = mix(CLOUD_RIM, 1.0, cloud_bite(detail, height));
    let eaten = cloud_erode(density, CLOUD_BITE * clouds.detail * bite);
    // Droplets grow on the way up: a base is thinner than a top.
    return clamp(eaten / clouds.softness, 0.0, 1.0) * mix(CLOUD_BASE_DENSITY, 1.0, height);
#endif
}

/// Extinction (1/m) at `p` (m), without what `footprint` (m) can't show.
fn cloud_extinction(p: vec3f, footprint: f32) -> f32 {
    return clouds.extinction * cloud_density_filtered(p, footprint);
}

/// Where ahead of `origin` a ray can meet clouds: from x to y (m), nowhere if x >= y.
fn cloud_ahead(origin: vec3f, direction: vec3f) -> vec2f {
    let span = cloud_span(origin, direction);
    let near = max(span.near, 0.0);
    return vec2f(near, min(span.far, near + clouds.far));
}

/// Estimate of the optical depth straight above (x) and below (y) `p` (m), without a march: from the cover there and
/// what the profile makes of mean noise.
fn cloud_depths(p: vec3f) -> vec2f {
    let height = clamp(cloud_height_fraction(p), 0.0, 1.0);
#if clouds.form == weather
    let weather = cloud_weather(p, height * clouds.thickness);
    return cloud_column(height, weather.cover, cloud_stops(weather.kind));
#else
    return cloud_column(height, 0.0, vec4f(0.0));
#endif
}

/// Optical depth above (x) and below (y) the `height` (fraction of the layer) of a column with such a cover and profile
/// (which only `weather` reads), as the mean noise fills it.
fn cloud_column(height: f32, cover: f32, stops: vec4f) -> vec2f {
    var depths = vec2f(0.0);
    for (var i = 0; i < CLOUD_COLUMN; i++) {
        let at = (f32(i) + 0.5) / f32(CLOUD_COLUMN);
#if clouds.form == weather
        let density = cloud_cover(CLOUD_MEAN * cloud_gradient(at, stops), min(cover - clouds.taper * at * at, 1.0));
        let eaten = cloud_erode(density, CLOUD_BITE * clouds.detail * 0.7);
        let here = clamp(eaten / clouds.softness, 0.0, 1.0) * mix(CLOUD_BASE_DENSITY, 1.0, at);
#elif clouds.form == plain
        // The share of the sheet that is cloud at this height.
        let here = clamp(0.5 + 1.5 * cloud_sheet(at), 0.0, 1.0);
#else
        let here = 0.45 * clouds.coverage * clouds.coverage * clouds.coverage;
#endif
        let above = clamp(0.5 + (at - height) * f32(CLOUD_COLUMN), 0.0, 1.0);
        depths += here * vec2f(above, 1.0 - above);
    }
    return depths * (clouds.extinction * clouds.thickness / f32(CLOUD_COLUMN));
}

/// What the layer's covered part makes of light, in the mean over the land: as a slab of the clouds' mean depth
/// (Eddington).
struct CloudsSlab {
    /// Optical depth from the lower to the upper side, along a level normal.
    depth: f32,
    /// Part of the sky's irradiance that reaches the ground; the rest of what comes from below goes back there.
    of_sky: f32,
    /// Part of the sun's that reaches the ground scattered.
    of_sun: f32,
}

/// The layer as a slab of its mean depth, under the sun of `day`.
fn clouds_slab(day: Daylight) -> CloudsSlab {
    let g = mix(clouds.back, clouds.forward, clouds.forward_share);
    // By how much a normal distribution exceeds a threshold where it does, in the mean: within 6 % from -4 to 1.
    let score = clamp(cloud_score(clouds.coverage), -4.0, 1.5);
    let excess = 0.8 + score * (0.118 * score - 0.363);
    let depths = cloud_column(0.0, CLOUD_BRINK + 0.35 * clouds.clumping * excess, cloud_stops(clouds.type));
    let whole = depths.x + depths.y;
    let depth = (1.0 - g) * whole;
    let mu = max(day.to_sun.y, 0.05);
    let beam = exp(-min(depth / mu, 80.0));
    let of_sun = max((0.667 + mu + (0.667 - mu) * beam) / (1.333 + depth) - beam, 0.0);
    return CloudsSlab(whole, 1.333 / (1.333 + depth), of_sun);
}

/// Irradiance of level ground under the layer by sky and clouds together, in the mean over the land: what lights an
/// overcast day. The sun's own beam is not in it (that is `day.sun` times `clouds_shadow`).
///
/// The open part of the sky as it is, the covered part as `clouds_slab`; and what the ground throws up to the clouds and
/// these throw back.
fn clouds_irradiance(day: Daylight) -> vec3f {
    return clouds_irradiance_under(clouds_slab(day), day);
}

/// As `clouds_irradiance`, of a `slab` that is known already.
fn clouds_irradiance_under(slab: CloudsSlab, day: Daylight) -> vec3f {
    let of_sun = max(day.to_sun.y, 0.0) * day.sun;
    let through = mix(day.sky, slab.of_sky * day.sky + slab.of_sun * of_sun, clouds.coverage);
    let back = clouds.ground * (clouds.coverage * (1.0 - slab.of_sky));
    return (through + back * (1.0 - clouds.coverage) * of_sun) / (1.0 - min(back, vec3f(0.98)));
}

/// Irradiance of the ground beneath the layer in the mean over sun and shadow.
fn clouds_ground_irradiance(slab: CloudsSlab, day: Daylight) -> vec3f {
    return (1.0 - clouds.coverage) * max(day.to_sun.y, 0.0) * day.sun + clouds_irradiance_under(slab, day);
}

/// What of the light of sun (x), sky (y) and ground (z) a place of a cloud sends to the eye: factors of the
/// irradiances of what faces the sun, of level ground, and of what the ground throws back; see <march/volume.wgsl>.
fn cloud_lit(p: vec3f, direction: vec3f, extinction: f32, light_depth: f32) -> vec3f {
    let medium = CloudMedium(clouds.forward, clouds.back, clouds.forward_share, clouds.albedo);
    let to_sun = key_direction();
    let up = cloud_up(p);
    let cos_theta = dot(direction, to_sun);
    let view_mu = dot(direction, up);
    let depths = cloud_depths(p);
    let sun_depth = light_depth / clouds.penetration;
#if clouds.scattering == once
    var sunny = cloud_source_single(cos_theta, sun_depth, medium);
#elif clouds.scattering == octaves
    var sunny = cloud_source_octaves(cos_theta, sun_depth, depths.x, depths.y, 6, medium);
#else
    let sun_mu = dot(to_sun, up);
    var sunny = cloud_source(cos_theta, sun_mu, view_mu, sun_depth, depths.x, depths.y, clouds.coverage, medium);
#endif
    let lobes = cloud_lobes(cos_theta, 1.0, medium);
    let lining = cloud_silver_lining(cos_theta, lobes, clouds.silver_lining, clouds.silver_spread) - lobes;
    let powder = mix(1.0, cloud_powder(sun_depth), clouds.powder);
    sunny = max(sunny + clouds.albedo * exp(-sun_depth) * lining, 0.0) * powder;
    let ambient = cloud_ambient_source(view_mu, depths.x, depths.y, medium);
    return vec3f(sunny, 0.31830989 * ambient);
}

/// What a ray sees of the clouds.
struct CloudsSeen {
    /// Radiance that they send to the ray's origin, without the air between.
    radiance: vec3f,
    /// Part of what is behind that shows, 0 .. 1.
    transmittance: f32,
    /// Mean distance of what is seen of them (m).
    distance: f32,
}

/// The clouds between `near` and `far` (m) along the unit `direction`, in the light of `day`.
///
/// `jitter`: 0 .. 1, another one for each pixel. `pixel_angle`: of a pixel (rad). Where the light differs from end to end of
/// what is seen, from orbit, take `clouds_found`, and light what it found by `clouds_lit`.
fn clouds_trace(
    origin: vec3f,
    direction: vec3f,
    near: f32,
    far: f32,
    jitter: f32,
    pixel_angle: f32,
    day: Daylight,
) -> CloudsSeen {
    let found = clouds_found(origin, direction, near, far, jitter, pixel_angle);
    let lit = clouds_lit(found.radiance, origin + min(found.distance, clouds.far) * direction, day);
    return CloudsSeen(lit, found.transmittance, found.distance);
}

/// As `clouds_trace`, not lit yet: instead of a radiance factors of the light of sun, sky and ground, see `cloud_lit`.
fn clouds_found(
    origin: vec3f,
    direction: vec3f,
    near: f32,
    far: f32,
    jitter: f32,
    pixel_angle: f32,
) -> CloudsSeen {
    let span = cloud_ahead(origin, direction);
    let begin = max(span.x, near);
    let end = min(span.y, far);
    if begin >= end {
        return CloudsSeen(vec3f(0.0), 1.0, far);
    }
    var how = cloud_effort();
    how.pixel_angle = CLOUD_DETAIL * pixel_angle;
    how.growth = min(how.growth, (end - begin) / (12.0 * end)); // from far away the layer is thin
    let seen = cloud_volume_march(origin, direction, begin, end, key_direction(), jitter, how);
    return CloudsSeen(seen.radiance, seen.transmittance, seen.distance);
}

/// `day` as the place `p` (m) has it: its sun as high as over the horizon there.
fn cloud_local(p: vec3f, day: Daylight) -> Daylight {
#if clouds.shape == shell
    let up = cloud_up(p);
    let height = dot(day.to_sun, up);
    return Daylight(vec3f(sqrt(max(1.0 - height * height, 0.0)), height, 0.0), day.radius, day.sun, day.sky);
#else
    return day;
#endif
}

/// Radiance of clouds around `p` (m), of which `clouds_found` found these `factors`, in the light `at_place` of the place.
fn clouds_lit(factors: vec3f, p: vec3f, at_place: Daylight) -> vec3f {
    let day = cloud_local(p, at_place);
    let slab = clouds_slab(day);
    let lit_ground = clouds_ground_irradiance(slab, day);
    // And flanks see other clouds where they would see the sky.
    let around = mix(day.sky, clouds_irradiance_under(slab, day), 0.4);
    return factors.x * day.sun + factors.y * around + factors.z * clouds.ground * lit_ground;
}

/// What the clouds are on average between the origin and `far` (m) along the unit `direction`, upward from below them: for
/// mirrors too rough to show each. No march.
fn clouds_mean(origin: vec3f, direction: vec3f, far: f32, day: Daylight) -> CloudsSeen {
    let span = cloud_ahead(origin, direction);
    let begin = span.x;
    let end = min(span.y, far);
    if begin >= end {
        return CloudsSeen(vec3f(0.0), 1.0, far);
    }
    // Seen at a slant, flanks hide gaps.
    let rows = 0.5 * (end - begin) * length(direction.xz) / clouds.scale;
    let hidden = 1.0 - pow(max(1.0 - clouds.coverage, 1e-3), 1.0 + rows);
    let flank = 1.0 - clouds.coverage / max(hidden, 1e-3);
    let slab = clouds_slab(day);
    let ground = clouds.ground * clouds_ground_irradiance(slab, day);
    let through = slab.of_sky * day.sky + slab.of_sun * max(day.to_sun.y, 0.0) * day.sun;
    let base = through + (1.0 - slab.of_sky) * ground;
    let side = 0.25 * day.sun + 0.5 * (day.sky + ground); // sunlit on one side, half sky and half ground around
    let opacity = hidden * (1.0 - exp(-slab.depth / max(direction.y, 0.05)));
    let radiance = opacity * mix(base, side, flank) / 3.14159265;
    return CloudsSeen(radiance, 1.0 - opacity, begin + (end - begin) / (2.0 + rows));
}

/// How much work the march does: about rungs b, d, f and g of the ladder that `cargo bench --bench clouds` climbs, with
/// steps that grow faster, for views farther than its own.
fn cloud_effort() -> cloud_volume_Volume {
    let unit = clouds.scale / 1000.0;
#if quality == low
    return cloud_volume_Volume(0.5, 0.9, 3, 26.0 * unit, 0.12, 4.0 * unit, 24, 0.1, 0.0);
#elif quality == medium
    return cloud_volume_Volume(0.2, 0.5, 10, 13.0 * unit, 0.009, 1.5 * unit, 128, 0.02, 0.0);
#elif quality == high
    return cloud_volume_Volume(0.1, 0.25, 12, 9.6 * unit, 0.006, 1.15 * unit, 192, 0.01, 0.0);
#else
    return cloud_volume_Volume(0.1, 0.2, 16, 7.0 * unit, 0.005, 0.77 * unit, 256, 0.004, 0.0);
#endif
}

/// Part of the sun, 0 .. 1, that the clouds leave to `position` (m).
fn clouds_shadow(position: vec3f, to_sun: vec3f) -> f32 {
    let span = cloud_ahead(position, to_sun);
    if span.x >= span.y {
        return 1.0;
    }
    return cloud_volume_shadow(position, to_sun, span.x, span.y, CLOUD_SHADOW_SAMPLES);
}
