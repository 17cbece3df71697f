// The engine's things: rasterised, in the light of Orogen's sun and sky, through Orogen's air.

#include <light/outdoor.wgsl>
#include <noise/pcg.wgsl>
#include <noise/perlin.wgsl>
#include <scene/guests.wgsl>
#include <scene/landscape.wgsl>
#include "view.wgsl"

const STONE: u32 = 0u;
const SHINGLES: u32 = 1u;
const WOOD: u32 = 2u;

const COURSE: f32 = 0.34; // height of a course of stones (m)

/// `v` (m) of the mesh, as the thing is turned.
fn thing_turned(v: vec3f, turn: vec2f) -> vec3f {
    return vec3f(turn.x * v.x - turn.y * v.z, v.y, turn.y * v.x + turn.x * v.z);
}

/// Albedo of the wall, the roof or the door at `p` (m) with the axis-near unit `normal`; what is smaller than `pixel` (m) is
/// left out.
fn thing_albedo(p: vec3f, normal: vec3f, material: u32, pixel: f32) -> vec3f {
    let along = select(p.x, p.z, abs(normal.x) > abs(normal.z));
    let weather = perlin_noise3(vec3f(1.3, 0.35, 1.3) * p, 5u) + 0.5 * perlin_noise3(4.0 * p, 6u);
    if material == SHINGLES {
        let row = floor(p.y / 0.22);
        let part = fract(p.y / 0.22);
        let shingle = floor(along / 0.16 + 0.5 * (row % 2.0));
        let tint = unit_float(pcg_cell2(vec2i(i32(shingle), i32(row)), 3u));
        let fine = 1.0 - smoothstep(0.05, 0.25, pixel);
        let edge = mix(1.0, mix(0.55, 1.0, smoothstep(0.0, 0.25, part)), fine);
        return vec3f(0.155, 0.135, 0.115) * edge * (1.0 + 0.35 * fine * (tint - 0.5) + 0.25 * weather);
    }
    if material == WOOD {
        let board = floor(along / 0.22);
        return vec3f(0.07, 0.048, 0.03) * (0.8 + 0.4 * unit_float(pcg_cell2(vec2i(i32(board), 7), 3u)));
    }
    if material > WOOD {
        return vec3f(0.012); // the dark behind an opening
    }
    // Courses of squared granite, each stone of its own grey, with mortar between them.
    let row = floor(p.y / COURSE);
    let v = fract(p.y / COURSE);
    let length = COURSE * (1.3 + 0.9 * unit_float(pcg_cell2(vec2i(i32(row), 2), 9u)));
    let u = along / length + unit_float(pcg_cell2(vec2i(i32(row), 1), 9u));
    let stone = vec2i(i32(floor(u)), i32(row));
    let joint = min(COURSE * min(v, 1.0 - v), length * min(fract(u), 1.0 - fract(u)));
    let fine = 1.0 - smoothstep(0.06, 0.4, pixel);
    let mortar = fine * (1.0 - smoothstep(0.008, 0.02 + pixel, joint));
    let tint = unit_float(pcg_cell2(stone, 4u)) - 0.5;
    let warm = unit_float(pcg_cell2(stone, 8u));
    let grey = mix(vec3f(0.25, 0.24, 0.225), vec3f(0.29, 0.26, 0.215), warm);
    let rough = perlin_noise3(9.0 * p, 7u) * (1.0 - smoothstep(0.02, 0.1, pixel));
    let damp = 0.35 * exp(-max(p.y, 0.0) / 0.9);
    let albedo = grey * (1.0 + fine * (0.6 * tint + 0.14 * rough) + 0.2 * weather - damp);
    return mix(albedo, vec3f(0.21, 0.20, 0.18), 0.8 * mortar);
}

/// What is seen of a thing at `relative` (m, from the eye), lit as the land beside it is, and hazed as the land behind it.
///
/// `local` and `local_normal` are in the mesh's own metres, `normal` in the world.
fn thing_radiance(index: u32, relative: vec3f, normal: vec3f, local: vec3f, local_normal: vec3f, material: u32) -> vec3f {
    let distance = length(relative);
    let direction = relative / distance;
    let position = view.eye + relative;
    let scale = view.things[index].scale;
    let pixel = distance * camera_pixel_angle() / scale;

    let day = scene_daylight(position, distance);
    let own_shadow = guests_shadow(position + 0.06 * scale * normal, day.to_sun);
    // The ground takes the sky from the wall's foot, the eaves from its top.
    let foot = 0.35 * exp(-max(local.y, 0.0) / 1.2);
    let eaves = select(0.5 * smoothstep(2.2, 0.0, 10.9 - local.y), 0.0, material == SHINGLES);
    let radiance = outdoor_radiance(
        thing_albedo(local, local_normal, material, pixel), normal, day.to_sun, day.sun, day.sky, own_shadow,
        1.0 - max(foot, eaves), terrain.surroundings,
    );
    return sky_through(scene_air(view.eye, direction, distance), radiance);
}
