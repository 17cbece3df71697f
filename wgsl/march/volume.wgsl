// A ray through a medium that is there in some places and not in others (clouds, smoke): the light it gathers, the
// light it lets through, shadows, and shafts of light.
//
// Most of a picture's cost is density that is asked where it does not matter. So: emptiness is jumped over (`vacancy`),
// steps inside are as long as the light that they hold allows (`part`), a step that turns out to hold too much is
// halved, what was asked beyond it being kept; and the way to the light is marched not once a step but once for every
// `light_part` of what is seen, from where the middle of that light comes from. Steps take the density as a line
// between both ends, light within them by (1 - e^-depth): no step count makes energy.

/// Extinction (1/m) at a place, 0 or more; details much smaller than `footprint` (m) may be left out.
#slot density: fn(p: vec3f, footprint: f32) -> f32

/// How far (m) from a place on the density is 0 for sure, in every direction; 0 where that is not known.
#slot vacancy: fn(p: vec3f) -> f32

/// From where to where (m, x < y, x >= 0) along a ray there can be anything at all; y <= x: nowhere.
#slot span: fn(origin: vec3f, direction: vec3f) -> vec2f

/// Radiance that leaves the medium toward `-direction` for a unit of optical depth (the source function: albedo times
/// what comes in, by the phase function): at a place, seen along `direction`, with this extinction (1/m), and with this
/// optical depth between it and the light.
#slot source: fn(p: vec3f, direction: vec3f, extinction: f32, light_depth: f32) -> vec3f

/// How a march trades speed for exactness.
struct Volume {
    /// Most of the light of a pixel that one step may hold, 0 .. 1: about 1 / part steps make a cloud opaque.
    part: f32,
    /// As `part`, for one march toward the light: about 1 / light_part of these.
    light_part: f32,
    /// Evaluations of one march toward the light.
    light_samples: i32,
    /// Step (m) where there may be something but is nothing: half of the smallest cloud that must not be missed.
    probe: f32,
    /// By how much that step grows with distance, as a part of it.
    growth: f32,
    /// Shortest step (m): as exactly is an edge found.
    shortest: f32,
    /// Steps along the ray at most; the last ones grow to reach the end.
    max_steps: i32,
    /// Transmittance below which the rest is left out, and what was seen scaled to make up for it.
    opaque: f32,
    /// Size of a pixel as an angle (rad): finer details need not be there, shorter steps are not taken. May be 0.
    pixel_angle: f32,
}

/// What a ray has seen.
struct VolumeSeen {
    /// Radiance that the medium sends to the ray's origin.
    radiance: vec3f,
    /// Part of the light from behind that comes through, 0 .. 1.
    transmittance: f32,
    /// Mean distance (m) of what is seen of the medium, weighted by how much that is; `far` if nothing is.
    distance: f32,
    /// Steps along the ray, those that were taken back included.
    steps: i32,
    /// Evaluations of `density`, those toward the light included.
    evaluations: i32,
}

/// Light gathered and let through between `near` and `far` (m) along a ray.
///
/// `direction` and `to_light` are unit vectors. `jitter` (0 .. 1, .5 for none) is how much of the first step is taken:
/// a number for each pixel turns bands into noise. Never gives more light than the brightest `source` on the ray times
/// (1 - transmittance). One flat loop with one call of `density`, `vacancy` and `source` each; turns: `max_steps`
/// + 3 + (2 / light_part + 1) `light_samples` at most.
fn march(
    origin: vec3f,
    direction: vec3f,
    near: f32,
    far: f32,
    to_light: vec3f,
    jitter: f32,
    how: Volume,
) -> VolumeSeen {
    var seen = VolumeSeen(vec3f(0.0), 1.0, far, 0, 0);
    let length = far - near;
    if !(length > 0.0) || how.max_steps < 1 {
        return seen;
    }
    let first = origin + near * direction; // distances are counted from here: near it they are fine, also from space
    let light_samples = max(how.light_samples, 1);
    let most_lights = i32(2.0 / clamp(how.light_part, 0.02, 1.0)) + 1;
    // The ray up to `at` is done; the density there is `here`, or not known yet.
    var at = 0.0;
    var here = 0.0;
    var known = false;
    var stride = -1.0; // a step that was halved
    var ahead_at = -1.0; // the nearest place beyond that was asked already
    var ahead = 0.0;
    var moment = 0.0; // of distance, over all that is seen
    // What is seen and not lit yet: its weight, moment of distance, moment of extinction.
    var dark = vec3f(0.0);
    var lights = 0;
    var light_index = -1; // of the evaluation toward the light; -1: along the ray
    var light_from = vec3f(0.0);
    var light_reach = 0.0;
    var light_power = 1.0;
    var light_footprint = 0.0;
    var light_depth = 0.0;
    var done = false;
    for (var turn = 0; turn < how.max_steps + 3 + most_lights * light_samples; turn++) {
        var place = first;
        var footprint = 0.0;
        var target_at = 0.0;
        var width = 0.0;
        var ask = true;
        if light_index >= 0 {
            let edges = pow(vec3f(0.0, 0.5, 1.0) + f32(light_index), vec3f(light_power))
                * (light_reach / pow(f32(light_samples), light_power));
            width = edges.z - edges.x;
            place = light_from + edges.y * to_light;
            footprint = max(light_footprint, 0.25 * width); // a quarter of a step does not show
        } else {
            if here <= 0.0 && stride < 0.0 {
                let free = vacancy(first + at * direction);
                at += max(free, 0.0);
                known = known || free > 0.0;
            }
            let t = near + at;
            let pixel = max(t, 0.0) * how.pixel_angle;
            if at >= length {
                done = true;
                ask = false;
            } else if known {
                seen.steps++;
                let left = how.max_steps - seen.steps + 1;
                let rest = (length - at) * min(3.0 / f32(left * left), 1.0); // the last steps reach the end
                var step = max(how.probe, how.growth * t);
                step *= select(1.0, clamp(jitter, 0.01, 1.0), seen.steps == 1);
                if stride > 0.0 {
                    step = stride;
                } else if here > 0.0 {
                    let allowed = -log(max(1.0 - how.part / seen.transmittance, 1e-2));
                    step = min(step, max(allowed / here, max(how.shortest, pixel)));
                }
                target_at = min(at + max(step, rest), length);
                if ahead_at > at && target_at > mix(at, ahead_at, 0.7) && left > 1 {
                    target_at = ahead_at;
                    ask = false;
                }
            } else {
                target_at = at;
            }
            place = first + target_at * direction;
            footprint = pixel;
        }
        var found = ahead;
        if ask {
            found = clamp(density(place, footprint), 0.0, 1e9);
            seen.evaluations++;
        }
        if light_index >= 0 {
            light_depth += found * width;
            light_index++;
        } else if !done {
            let step = target_at - at;
            // Where it begins to be dense, if the density rises as it does behind: an edge between two places.
            var empty = 0.0;
            if here <= 0.0 && ahead_at > target_at && ahead > found {
                empty = clamp(step - found * (ahead_at - target_at) / (ahead - found), 0.0, step);
            }
            let full = step - empty;
            let depth = 0.5 * (here + found) * full;
            let weight = seen.transmittance * (1.0 - exp(-depth));
            let pixel = max(near + at, 0.0) * how.pixel_angle;
            if known && weight > 1.5 * how.part && step > 2.0 * max(how.shortest, pixel)
                && seen.steps + 8 < how.max_steps
            {
                // Too much in one step: back.
                stride = step * clamp(sqrt(how.part / weight), 0.2, 0.5);
                ahead_at = target_at;
                ahead = found;
            } else {
                // Where in the step the middle of its light comes from: by parts, and Simpson's rule.
                var part = (here + 2.0 * found) / max(3.0 * (here + found), 1e-20);
                if depth > 3.0 {
                    part = 1.0 / depth;
                } else if depth > 0.05 {
                    let half = exp(-0.125 * (3.0 * here + found) * full);
                    let end = exp(-depth);
                    part = ((1.0 + 4.0 * half + end) / 6.0 - end) / (1.0 - end);
                }
                let middle = at + empty + part * full;
                if known {
                    dark += weight * vec3f(1.0, middle, 0.5 * (here + found));
                    seen.transmittance *= exp(-depth);
                }
                at = target_at;
                here = found;
                known = true;
                stride = -1.0;
                done = at >= length || seen.transmittance < max(how.opaque, 1e-7);
            }
            done = done || seen.steps >= how.max_steps;
        }
        // Enough of it to be lit, or a gap behind it.
        var lit = light_index >= light_samples;
        if light_index < 0 && dark.x > 0.0
            && (done || dark.x >= how.light_part || (here <= 0.0 && stride < 0.0))
        {
            light_from = first + dark.y / dark.x * direction;
            if dark.x >= 0.02 * how.light_part && lights < most_lights {
                lights++;
                light_index = 0;
                light_depth = 0.0;
                light_footprint = max(near + dark.y / dark.x, 0.0) * how.pixel_angle;
                light_reach = max(span(light_from, to_light).y, 1e-3);
                let close = clamp(0.5 * dark.x / max(dark.z, 1e-20), 1e-3 * light_reach, light_reach);
                light_power = clamp(log(light_reach / close) / log(max(f32(light_samples), 2.0)), 1.0, 4.0);
            } else {
                lit = true; // hardly to be seen: the depth of the last place will do
            }
        }
        if lit {
            seen.radiance += dark.x * source(light_from, direction, dark.z / dark.x, light_depth);
            moment += dark.y;
            dark = vec3f(0.0);
            light_index = -1;
        }
        if done && light_index < 0 {
            break;
        }
    }
    let covered = 1.0 - seen.transmittance;
    if covered > 0.0 {
        seen.distance = near + clamp(moment / covered, 0.0, length);
    }
    if seen.transmittance < how.opaque {
        seen.radiance /= covered;
        seen.transmittance = 0.0;
    }
    return seen;
}

// Optical depth from which on a shadow is as dark as it gets: a four-hundredth of the light is left.
const SHADOW_DEEP: f32 = 6.0;

/// Part of a distant light, 0 .. 1, that comes through to `position` from between `near` and `far` (m) toward it.
///
/// The way is taken in steps of a part in `samples` of it, with one evaluation in the middle of each; emptiness that is
/// known is jumped over, and no step is taken beyond a depth of `SHADOW_DEEP`: in clouds two of three evaluations are
/// spared. Details finer than a quarter of a step are left out.
fn shadow(position: vec3f, to_light: vec3f, near: f32, far: f32, samples: i32) -> f32 {
    let spacing = max(far - near, 0.0) / f32(max(samples, 1));
    var at = near;
    var here = 0.0;
    var depth = 0.0;
    for (var i = 0; i < samples; i++) {
        if here <= 0.0 {
            at += max(vacancy(position + at * to_light), 0.0);
        }
        if at >= far || depth >= SHADOW_DEEP {
            break;
        }
        let step = min(spacing, far - at);
        here = clamp(density(position + (at + 0.5 * step) * to_light, 0.25 * step), 0.0, 1e9);
        depth += here * step;
        at += step;
    }
    return exp(-depth);
}

/// Mean part of a distant light, 0 .. 1, that reaches the air along a view ray between `near` and `far` (m): what the
/// air's first-order light from it is to be multiplied by.
///
/// `thinning` (1/m): places count by e^(-thinning t), as the air thins out and hides itself; below 0 the far ones count
/// more. `samples` places, each equally much, moved along by `jitter` (0 .. 1), and `light_samples` evaluations from
/// each through what `span` says is there.
fn shafts(
    origin: vec3f,
    direction: vec3f,
    near: f32,
    far: f32,
    thinning: f32,
    to_light: vec3f,
    jitter: f32,
    samples: i32,
    light_samples: i32,
) -> f32 {
    let length = far - near;
    if !(length > 0.0) || samples < 1 || light_samples < 1 {
        return 1.0;
    }
    let fade = clamp(thinning * length, -30.0, 30.0);
    let whole = 1.0 - exp(-fade);
    var sum = 0.0;
    var depth = 0.0;
    var place = origin;
    var light = vec2f(0.0);
    for (var i = 0; i < samples * light_samples; i++) {
        let j = i % light_samples;
        if j == 0 {
            let u = (f32(i / light_samples) + clamp(jitter, 0.0, 1.0)) / f32(samples);
            let part = select(-log(max(1.0 - u * whole, 1e-20)) / fade, u, abs(fade) < 1e-3);
            place = origin + (near + part * length) * direction;
            light = span(place, to_light);
            light.y = max(light.y - light.x, 0.0) / f32(light_samples);
            depth = 0.0;
        }
        if light.y > 0.0 {
            let t = light.x + light.y * (f32(j) + 0.5);
            depth += clamp(density(place + t * to_light, 0.5 * light.y), 0.0, 1e9) * light.y;
        }
        if j == light_samples - 1 {
            sum += exp(-depth);
        }
    }
    return sum / f32(samples);
}
