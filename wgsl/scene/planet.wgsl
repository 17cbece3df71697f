// A planet, from space down to the ground: land and sea, clouds and air.
//
// The world's origin lies on the planet's sphere at `planet.latitude` and `planet.longitude`; the planet's centre is
// `sky.ground_radius` beneath it. The camera is placed from there.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <frame.wgsl>
#include <geometry/globe.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <light/outdoor.wgsl>
#include <march/globe.wgsl> as globe with above = planet_above_marched
#include <march/hit.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <planet/globe.wgsl>
#include <planet/height.wgsl>
#include <planet/material.wgsl>
#include <quality.wgsl>
#include <scene/weather.wgsl>
#include <sky/air.wgsl>
#include <sky/sky.wgsl>

/// Whether there is a sea.
#option planet.water = true
/// Whether there are clouds as they look from orbit. What they are up close, below some 50 km, `weather.clouds` shows, with
/// `clouds.shape` = `shell`.
#option planet.clouds = true
/// Whether mountains throw shadows.
#option planet.shadows = true

/// Whether trees stand around the world's origin, where `trees.*` say so. They stand on land: `terrain.relief` must be
/// `planet` then.
#option planet.trees = false

#if planet.trees
#include <trees/trees.wgsl>
#endif
#if planet.water
#include <water/level.wgsl>
#include <water/shade.wgsl>
#endif
#if planet.clouds
#include <planet/clouds.wgsl>
#endif

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m), to the ground or the sea; `RAY_FAR` for the sky.
    distance: f32,
}

// Steps few enough for software GPUs, which end all loops of eight pixels after 65,535 turns in total: a step takes up to
// some forty octaves on each of the planes that count.
#if quality == low
const GROUND_STEPS: i32 = 6;
const GROUND_GROWTH: f32 = 0.4;
const GROUND_REFINEMENTS: i32 = 1;
const GROUND_DETAIL: f32 = 2.0; // width of the smallest detail looked at, in pixels
const GROUND_BLUR: f32 = 24.0; // how much coarser the ground may be that rays look for
const GROUND_STEEP: f32 = 0.8; // slope that steps are made for
const GROUND_FLAT: f32 = 40.0; // how many times as high as the highest mountains the eye is when these look flat
const GROUND_UNDER: f32 = 0.5; // width of the smallest detail beneath the camera that lifts it, by its height
const SHADOW_LOOKS: i32 = 2;
const SHADOW_FINEST: f32 = 300.0; // pixels so wide (m) see no shadows of mountains
const SHELL_SHADE: f32 = 16.0; // how much coarser the clouds are that throw shadows than those that are seen
const SHELL_RELIEF: bool = false; // whether heaps of cloud shade each other, and the air up to them is looked at
const SEA_MIRRORS: f32 = 3000.0; // height (m) of the eye up to which the sea mirrors more than the mean of the sky
#elif quality == medium
const GROUND_STEPS: i32 = 70;
const GROUND_GROWTH: f32 = 0.04;
const GROUND_REFINEMENTS: i32 = 8;
const GROUND_DETAIL: f32 = 1.0;
const GROUND_BLUR: f32 = 1.0;
const GROUND_UNDER: f32 = 0.02;
const SHADOW_LOOKS: i32 = 9;
const SHADOW_FINEST: f32 = RAY_FAR;
const SHELL_SHADE: f32 = 1.0;
const SHELL_RELIEF: bool = true;
const SEA_MIRRORS: f32 = RAY_FAR;
#elif quality == high
const GROUND_STEPS: i32 = 110;
const GROUND_GROWTH: f32 = 0.025;
const GROUND_REFINEMENTS: i32 = 8;
const GROUND_DETAIL: f32 = 1.0;
const GROUND_BLUR: f32 = 1.0;
const GROUND_UNDER: f32 = 0.02;
const SHADOW_LOOKS: i32 = 12;
const SHADOW_FINEST: f32 = RAY_FAR;
const SHELL_SHADE: f32 = 1.0;
const SHELL_RELIEF: bool = true;
const SEA_MIRRORS: f32 = RAY_FAR;
#else
const GROUND_STEPS: i32 = 140;
const GROUND_GROWTH: f32 = 0.015;
const GROUND_REFINEMENTS: i32 = 8;
const GROUND_DETAIL: f32 = 1.0;
const GROUND_BLUR: f32 = 1.0;
const GROUND_UNDER: f32 = 0.02;
const SHADOW_LOOKS: i32 = 16;
const SHADOW_FINEST: f32 = RAY_FAR;
const SHELL_SHADE: f32 = 1.0;
const SHELL_RELIEF: bool = true;
const SEA_MIRRORS: f32 = RAY_FAR;
#endif
const GROUND_RELAX: f32 = 0.7;

// What a ray may see, each through air of its own: clouds, the ground or the sea or the sky, and what the sea mirrors.
const PLANET_CLOUDS: i32 = 0;
const PLANET_GROUND: i32 = 1;
const PLANET_MIRRORED: i32 = 2;

/// Height (m) of `p` (m) above the ground as a march looks at it.
fn planet_above_marched(p: vec3f, footprint: f32) -> f32 {
    return planet_above(p, GROUND_BLUR * footprint);
}

/// What is seen from `origin` (m) in the unit `direction`.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    return planet_trace(origin, direction, 0.5);
}

/// As `scene_trace`; `jitter` is where in their first steps the marches through clouds begin, 0 .. 1: another one for each
/// pixel turns bands into fine noise.
fn planet_trace(origin: vec3f, direction: vec3f, jitter: f32) -> Traced {
    let pixel = GROUND_DETAIL * camera_pixel_angle();
    var relax = GROUND_RELAX;
#if quality == low
    // As far as ground that rises by `GROUND_STEEP` needs to reach up to the ray.
    relax = 1.0 / max(GROUND_STEEP - dot(direction, planet_up(origin)), 0.25);
#endif
    let steps = globe_Steps(0.2, GROUND_GROWTH, relax, GROUND_STEPS, GROUND_REFINEMENTS, pixel);
    var far = RAY_FAR;
#if planet.water
    let sea = globe_span(origin, direction, sky.ground_radius, water.level);
    let afloat = planet_altitude(origin) >= water.level;
    far = select(RAY_FAR, sea.near, afloat && sea.near > 0.0 && sea.near <= sea.far);
#endif
#if quality == low
    // From where mountains are thinner than a pixel nothing is marched: the ground is met at sea level.
    let from_afar = planet_altitude(origin) > GROUND_FLAT * planet_ceiling();
    var land = MarchHit(far, false, 0, 0);
    if from_afar {
        let level = globe_span(origin, direction, sky.ground_radius, 0.0);
        land.hit = level.near > 0.0 && level.near <= level.far;
        land.distance = select(far, level.near, land.hit);
    } else {
        land = globe_march(origin, direction, sky.ground_radius, planet_ceiling(), far, steps);
    }
#else
    let land = globe_march(origin, direction, sky.ground_radius, planet_ceiling(), far, steps);
#endif
    var way = select(far, land.distance, land.hit);
    var ends = land.hit;
    var wet = false;
    var near_sea = false;
#if planet.water
    // The march ends within half a pixel of the ground: where that is near the sea's surface, the depth there decides.
    let slack = 0.5 * pixel * way;
    near_sea = far < RAY_FAR && (!land.hit || planet_altitude(origin + way * direction) < water.level + slack);
    way = select(way, far, near_sea);
    ends = ends || near_sea;
#endif

#if planet.trees
    let tree = trees_trace(origin, direction, 0.0, select(trees.far, way, ends));
    let leafy = tree.hit;
    way = select(way, tree.distance, leafy);
    ends = ends || leafy;
#else
    let leafy = false;
#endif

    // The ground there, or the bed of the sea.
    var end = origin + select(0.0, way, ends) * direction;
    let footprint = pixel * select(0.0, way, ends);
    let up = planet_up(end);
    var albedo = vec3f(0.0);
    var normal = up;
    var sun_seen = 1.0;
    var steepness = 0.0;
#if planet.water
    var depth = 0.0;
    var frozen = 0.0;
#endif
    let to_key = key_direction();
    if ends {
        // Toward the limb a pixel is long and narrow: its mean width counts.
        let covered = footprint * inverseSqrt(max(-dot(direction, up), 0.02));
        let ground = planet_ground(end, covered);
        steepness = length(ground.slope);
#if planet.water && quality == low
        // What was met is coarser than what is seen: where that lies under water, it is the sea that is seen.
        if far < RAY_FAR && ground.height < water.level && !leafy {
            near_sea = true;
            way = far;
            end = origin + way * direction;
        }
#endif
        if land.hit && !near_sea && !leafy {
            // Half a pixel may be higher than all of the air: the rest of the way down.
            way += (planet_altitude(end) - ground.height) / max(-dot(direction, up), 0.25);
            way = max(way, 0.0);
            end = origin + way * direction;
        }
        let cover = planet_cover_at(end, up, ground.height, steepness, covered);
        albedo = cover.albedo;
        normal = planet_normal(up, ground.slope);
#if planet.water
        frozen = cover.frozen;
        depth = water.level - ground.height;
        wet = near_sea && depth > 0.0 && !leafy;
        if wet {
            normal = up;
        }
#endif
    }

#if planet.clouds
    // Clouds where the ray meets their shell, the clouds between there and the sun, and those over the ground.
    let canopy = globe_span(origin, direction, sky.ground_radius, shell.height);
    let inside = planet_altitude(origin) < shell.height;
    var cloud_way = select(canopy.near, canopy.far, inside);
    let meets = canopy.near <= canopy.far && cloud_way > 0.0 && cloud_way < way;
    cloud_way = select(0.0, cloud_way, meets);
    let cloud_at = origin + cloud_way * direction;
    let axes = planet_axes();
    var thick = vec3f(0.0);
    for (var i = 0; i < 3; i++) {
        var start_at = cloud_at;
        var ahead = 0.0;
        if i == 1 {
            ahead = max(4000.0, 1.5 * pixel * cloud_way);
        } else if i == 2 {
            start_at = end;
            let climb = max(dot(up, to_key), 0.08);
            ahead = (shell.height - planet_altitude(end)) / climb;
        }
        if (i == 2 && !ends) || (i < 2 && !meets) || (i == 1 && (thick.x <= 0.0 || !SHELL_RELIEF)) {
            continue;
        }
#if quality == low
        if i == 2 && from_afar && meets {
            thick.z = thick.x; // their shadow lies beneath them, a pixel or two aside
            continue;
        }
#endif
        let slant = max(abs(dot(direction, planet_up(start_at))), 0.02);
        let seen = pixel * select(cloud_way, way, i == 2) * inverseSqrt(slant) / sky.ground_radius;
        thick[i] = shell_at(axes * planet_up(start_at + ahead * to_key), select(SHELL_SHADE, 1.0, i == 0) * seen);
    }
#endif

#if planet.shadows
    if ends && footprint < SHADOW_FINEST && dot(up, to_key) > -0.1 && (leafy || dot(normal, to_key) > 0.0) {
        let start = max(footprint, 1.0);
        let start_at = end + 0.5 * start * normal;
        let reach = min(planet_ceiling() / max(dot(up, to_key), 0.04), 200000.0);
        if reach > start {
            sun_seen = globe_shadow(start_at, to_key, max(key_radius(), 0.004), start, reach, footprint, SHADOW_LOOKS);
        }
    }
#endif

#if planet.trees
    if ends && sun_seen > 0.0 && way < trees.far {
        sun_seen *= trees_shadow(end, footprint, Daylight(to_key, key_radius(), vec3f(1.0), vec3f(0.0)));
    }
#endif

    var radiance = vec3f(0.0);
    var passed = vec3f(0.0); // of what the sea mirrors
    var mirrored = direction;
    var blur = 0.0; // of what it mirrors
    var cloud_radiance = vec3f(0.0);
    var cloud_opacity = 0.0;
    var day: Daylight;
    var day_holds = false; // for the next of them, too
    for (var i = 0; i <= PLANET_MIRRORED; i++) {
        var start_at = origin;
        var toward = direction;
        var distance = way;
        var place = select(origin, end, ends);
#if planet.clouds
        if i == PLANET_CLOUDS {
            distance = cloud_way;
            place = cloud_at;
        }
        if i == PLANET_CLOUDS && thick.x <= 0.0 {
            continue;
        }
#else
        if i == PLANET_CLOUDS {
            continue;
        }
#endif
        if i == PLANET_MIRRORED {
            if max(passed.x, max(passed.y, passed.z)) < 0.004 {
                break;
            }
            start_at = end + 2.0 * up;
            toward = mirrored;
            distance = RAY_FAR;
        }
        if !day_holds {
            day = weather_daylight(place);
        }
        day_holds = i == PLANET_GROUND; // what the sea mirrors starts where the ground ends
#if planet.clouds
        day_holds = day_holds || (!SHELL_RELIEF && !inside); // from above, the ground is beneath its clouds
#endif
        if i == PLANET_MIRRORED && planet_altitude(origin) > SEA_MIRRORS {
            radiance += passed * day.sky / 3.14159265;
            break;
        }
        let here = planet_up(place);
        let compass = globe_frame(here);
        let local_sun = day.to_sun * compass;
        var lit = vec3f(0.0);
        if i == PLANET_GROUND && ends {
            var sunlight = day.sun * sun_seen;
#if weather.clouds || weather.second_layer
            if sun_seen > 0.0 {
                sunlight *= weather_sun_seen(end, day);
            }
#endif
#if planet.clouds
            let over = shell_transmittance(shell_depth(thick.z));
            sunlight *= over;
#endif
            lit = outdoor_radiance(albedo, normal * compass, local_sun, sunlight, day.sky, 1.0, 1.0, albedo);
#if planet.trees
            let under_sun = Daylight(day.to_sun, day.radius, sunlight, day.sky);
            if leafy {
                lit = trees_shade(origin, direction, tree, under_sun, 1.0);
            }
#endif
#if planet.water
            if wet {
                let local_day = Daylight(local_sun, day.radius, sunlight, day.sky);
                let surface = water_seen_from_above(
                    end, toward * compass, footprint / max(-dot(toward, here), 0.02), lit, depth, depth,
                    water_edge(footprint, steepness), local_day, 1.0,
                );
                mirrored = compass * surface.direction;
                blur = surface.blur;
                passed = surface.passed * (1.0 - frozen);
                let ice = planet.snow * (sunlight * max(local_sun.y, 0.0) + day.sky) / 3.14159265;
                lit = mix(surface.own, ice, frozen);
            }
#endif
        }
#if planet.clouds
        if i == PLANET_CLOUDS {
            if !SHELL_RELIEF {
                thick.y = thick.x;
            }
            let tau = shell_depth(thick.x);
            let between = shell_transmittance(2.0 * shell_depth(thick.y));
            let through = shell_transmittance(tau);
            // Heaps are bright on the side of the sun, dark on the other.
            let relief = clamp(1.0 + 1.5 * (thick.x - thick.y), 0.5, 1.2);
            let irradiance = day.sun * max(local_sun.y, 0.0) * relief * mix(0.6, 1.0, between) + day.sky;
            // Seen flat, a thin cloud hides more.
            cloud_opacity = 1.0 - shell_transmittance(tau / max(abs(dot(direction, here)), 0.15));
            let returned = select((1.0 - through) / max(cloud_opacity, 1e-4), through, inside);
            lit = min(returned * max(relief, 1.0), 1.0) / max(relief, 1.0) * irradiance / 3.14159265;
        }
#endif
        var behind = lit;
        if i == PLANET_GROUND && !ends {
            behind = sky_beyond(toward);
        }
        let air_blur = select(0.0, blur, i == PLANET_MIRRORED);
#if planet.clouds
        if !SHELL_RELIEF && !inside {
            // From high above, the air up to the clouds is nearly that up to the ground.
            if i == PLANET_CLOUDS {
                cloud_radiance = lit;
                continue;
            } else if i == PLANET_GROUND {
                behind = mix(behind, cloud_radiance, cloud_opacity);
                passed *= 1.0 - cloud_opacity;
                cloud_opacity = 0.0;
            }
        }
#endif
        let seen = sky_through(weather_air_blurred(start_at, toward, distance, jitter, air_blur, day), behind);
        if i == PLANET_CLOUDS {
            cloud_radiance = seen;
        } else if i == PLANET_GROUND {
            radiance = seen;
            if !wet {
                break;
            }
        } else {
            radiance += passed * seen;
        }
    }
    radiance = mix(radiance, cloud_radiance, cloud_opacity);
    return Traced(radiance, way);
}

/// The light that falls on a thing of a host's own at `position` (m), seen from `distance` (m) away: the sun, as far as the
/// ground, trees and clouds leave it, and the sky. What the host's things keep from each other is the host's.
fn scene_daylight(position: vec3f, distance: f32) -> Daylight {
    var day = weather_daylight(position);
    let footprint = camera_pixel_angle() * distance;
    let up = planet_up(position);
    let climb = dot(up, day.to_sun);
    var seen = weather_sun_seen(position, day);
#if planet.clouds
    let below = shell.height - planet_altitude(position);
    if below > 0.0 {
        let pierced = planet_axes() * planet_up(position + below / max(climb, 0.08) * day.to_sun);
        seen *= shell_transmittance(shell_depth(shell_at(pierced, footprint / sky.ground_radius)));
    }
#endif
#if planet.shadows
    let start = max(footprint, 1.0);
    let reach = min(planet_ceiling() / max(climb, 0.04), 200000.0);
    if seen > 0.0 && climb > -0.1 && reach > start {
        seen *= globe_shadow(position, day.to_sun, max(day.radius, 0.004), start, reach, footprint, SHADOW_LOOKS);
    }
#endif
#if planet.trees
    if seen > 0.0 {
        seen *= trees_shadow(position, footprint, day);
    }
#endif
    day.sun *= seen;
    return day;
}

/// Air and clouds between `origin` (m) and what a host draws `distance` (m) away in the unit `direction`; `sky_through` has a
/// radiance seen through them.
fn scene_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
    return weather_air(origin, direction, distance, 0.5, weather_daylight(origin + distance * direction));
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    // Counted from sea level and above all mountains, the camera does not need to know the ground; high above it, not what is
    // small.
    var under = 0.0;
    if camera.above_ground || camera.position.y < planet_ceiling() + camera.clearance {
        let finest = max(GROUND_UNDER * camera.position.y, 0.0);
        under = planet_ground(vec3f(camera.position.x, 0.0, camera.position.z), finest).height;
    }
    let ray = camera_ray(frag_coord, under);
    let jitter = interleaved_gradient_noise(frag_coord, frame.index);
    let seen = planet_trace(ray.origin, ray.direction, jitter);
    return vec4f(display_color(seen.radiance, frag_coord), 1.0);
}
