// A rough surface as many small mirrors whose slopes are spread normally (Cox & Munk 1954): which of them are seen, and
// what they mirror.
//
// All in the vertical plane of view: a slope is positive where a facet leans toward the eye, `tan_view` is the tangent of
// the eye's elevation above the surface, `deviation` > 0 the slopes' standard deviation along that plane.

/// Area of the facets as seen by the eye, over the level surface's times the cosine of the elevation: `tan_view` for a
/// smooth surface, more near grazing, never 0. Facets do not hide each other here.
fn facets_seen_area(tan_view: f32, deviation: f32) -> f32 {
    let u = max(tan_view / deviation, -4.0);
    return deviation * (u * normal_below(u) + normal_density(u));
}

/// Mean and standard deviation of the slopes that the eye sees: each facet counts by its area as seen.
///
/// Closed form (Stein's lemma): at grazing angles the facets that lean toward the eye hide the others, and the mean is 1.25
/// deviations; seen from above it is 0. `tan_view` + mean > 0 for `tan_view` >= -4 deviations: what is seen is seen from
/// its front.
fn facets_seen_slope(tan_view: f32, deviation: f32) -> vec2f {
    let u = max(tan_view / deviation, -4.0);
    let below = normal_below(u);
    let density = normal_density(u);
    let area = max(u * below + density, 1e-9);
    let mean = below / area;
    let variance = max(1.0 + density / area - mean * mean, 0.0);
    return deviation * vec2f(mean, sqrt(variance));
}

/// Radiance of a distant light mirrored by the facets, for 1 of irradiance facing it and facets that reflect all: a glint
/// or a glitter path. Per unit of level surface, in all at most as much light as comes in.
///
/// `half_slope`: slope of the facet that mirrors the light into the eye less the mean slope, and `half_cosine` its
/// normal's upward component; `deviation` > 0, alike in both directions; `seen_area` is `facets_seen_area` times the
/// cosine of the eye's elevation.
fn facets_glint(half_slope: vec2f, half_cosine: f32, deviation: f32, seen_area: f32) -> f32 {
    let variance = deviation * deviation;
    let spread = exp(-min(0.5 * dot(half_slope, half_slope) / variance, 80.0)) / (6.2831853 * variance);
    let c2 = half_cosine * half_cosine;
    return spread / (4.0 * c2 * c2 * seen_area);
}

/// Density of the standard normal distribution.
fn normal_density(x: f32) -> f32 {
    return 0.39894228 * exp(-0.5 * min(x * x, 160.0));
}

/// Part of the standard normal distribution that lies below `x`; error below 1e-7 (Abramowitz & Stegun 26.2.17).
fn normal_below(x: f32) -> f32 {
    let t = 1.0 / (1.0 + 0.2316419 * abs(x));
    let poly = t * (0.319381530 + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429))));
    let above = normal_density(x) * poly;
    return select(above, 1.0 - above, x >= 0.0);
}
