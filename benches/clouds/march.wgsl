// The contestants, over the density of the cloud layer: the library's march, and a plain one in even steps.

#include <clouds/layer.wgsl>
#include <sun/key.wgsl>
#include <march/volume.wgsl> as ours with density = cloud_extinction, vacancy = cloud_vacancy, span = cloud_ahead, source = cloud_lit

/// As far as is looked (m): there the reference's steps are at most 31 m long.
const BENCH_FAR: f32 = 16000.0;

/// Where a ray looks for clouds (m).
fn bench_span(origin: vec3f, direction: vec3f) -> vec2f {
    return min(cloud_ahead(origin, direction), vec2f(BENCH_FAR));
}

/// The library's march.
fn bench_ours(origin: vec3f, direction: vec3f, jitter: f32, how: ours_Volume) -> ours_VolumeSeen {
    let span = bench_span(origin, direction);
    return ours_march(origin, direction, span.x, span.y, key_direction(), jitter, how);
}

/// `count` of `steps` even steps from the one called `start` on, each in the middle (`jitter` .5) of its part of the ray,
/// and from each that meets cloud `light_steps` even ones to where the layer ends toward the light. All of it is one
/// loop, with one call of the density. `distance` is left 0.
fn bench_plain(
    origin: vec3f,
    direction: vec3f,
    jitter: f32,
    pixel_angle: f32,
    start: i32,
    count: i32,
    steps: i32,
    light_steps: i32,
) -> ours_VolumeSeen {
    var seen = ours_VolumeSeen(vec3f(0.0), 1.0, 0.0, 0, 0);
    let span = bench_span(origin, direction);
    let width = (span.y - span.x) / f32(steps);
    if !(width > 0.0) {
        return seen;
    }
    let to_light = key_direction();
    var footprint = 0.0;
    var place = origin;
    var extinction = 0.0;
    var light = -1; // -1: along the ray
    var light_width = 0.0;
    var light_depth = 0.0;
    for (var turn = 0; turn < count * (light_steps + 1); turn++) {
        var at = place + light_width * (f32(light) + 0.5) * to_light;
        if light < 0 {
            if seen.steps >= count {
                break;
            }
            let t = span.x + width * (f32(start + seen.steps) + jitter);
            at = origin + t * direction;
            footprint = pixel_angle * t;
            seen.steps++;
        }
        let found = cloud_extinction(at, footprint);
        seen.evaluations++;
        if light >= 0 {
            light_depth += found * light_width;
            light++;
        } else if found > 0.0 {
            place = at;
            extinction = found;
            light = 0;
            light_width = cloud_ahead(at, to_light).y / f32(light_steps);
            light_depth = 0.0;
        }
        if light == light_steps {
            light = -1;
            let through = exp(-extinction * width);
            let weight = seen.transmittance * (1.0 - through);
            seen.radiance += weight * cloud_lit(place, direction, extinction, light_depth);
            seen.transmittance *= through;
        }
    }
    return seen;
}
