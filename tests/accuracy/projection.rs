//! Pictures of everything around: which way each place of them looks.

use std::f64::consts::{PI, TAU};

use truth::geometry::{Vec3, cube_texel, distance, length};
use truth::points::Random;

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Geometry";

const SCOPE: Scope<'_> = Scope { includes: &["<geometry/projection.wgsl>"], fragment: "", preset: None };

/// Directions at `points` (face, u, v) of a cube.
fn on_cube(points: &[[f32; 3]]) -> Vec<Vec3> {
    let rows = values("cube_direction(i32(face), vec2f(u, v))", &SCOPE, ["face", "u", "v"], points);
    rows.iter().map(|row| [row[0], row[1], row[2]]).collect()
}

#[test]
fn a_cube_s_faces_look_where_gpus_sample_them() {
    let mut random = Random::new(3);
    let points: Vec<[f32; 3]> = (0..100_000)
        .map(|i| [(i % 6) as f32, random.within(0.0001, 0.9999), random.within(0.0001, 0.9999)])
        .collect();
    let (mut off, mut stretched, mut other) = (0.0_f64, 0.0_f64, 0);
    for (point, direction) in points.iter().zip(on_cube(&points)) {
        let [x, y, z] = direction;
        let (face, [s, t]) = cube_texel([x, y, -z]);
        let [u, v] = [point[1], point[2]].map(f64::from);
        other += usize::from(face != point[0] as usize);
        off = off.max((s - u).abs()).max((t - (1.0 - v)).abs());
        stretched = stretched.max((length(direction) - 1.0).abs());
    }
    let mut report = Report::new(SECTION, "a_cube_s_faces_look_where_gpus_sample_them");
    report.at_most("cube: directions of 100,000 that are sampled on another face", other as f64, 0.0);
    report.at_most("cube: off the place on the face that is sampled, of its side", off, 5e-7);
    report.at_most("cube: length of a direction off 1", stretched, 3e-7);
    report.finish();
}

#[test]
fn a_cube_s_faces_meet_at_their_edges() {
    const STEPS: usize = 64;
    let mut points = Vec::new();
    for face in 0..6_u8 {
        for step in 0..=STEPS {
            let at = step as f32 / STEPS as f32;
            points.extend([[at, 0.0], [at, 1.0], [0.0, at], [1.0, at]].map(|[u, v]| [f32::from(face), u, v]));
        }
    }
    let directions = on_cube(&points);
    let mut apart = 0.0_f64;
    for (point, here) in points.iter().zip(&directions) {
        let others = points.iter().zip(&directions).filter(|(other, _)| other[0] != point[0]);
        let nearest = others.map(|(_, there)| distance(*here, *there)).fold(f64::INFINITY, f64::min);
        apart = apart.max(nearest);
    }
    let mut report = Report::new(SECTION, "a_cube_s_faces_meet_at_their_edges");
    report.at_most("cube: an edge's direction off that of the face beside it (rad)", apart, 3e-7);
    report.finish();
}

#[test]
fn a_panorama_is_even_in_azimuth_and_elevation() {
    let mut random = Random::new(4);
    let points: Vec<[f32; 2]> = (0..100_000)
        .map(|i| match i % 8 {
            0 => [random.within(0.0, 1.0), 0.0],
            1 => [random.within(0.0, 1.0), 1.0],
            _ => [random.within(-1.0, 2.0), random.within(0.0, 1.0)],
        })
        .collect();
    let rows = values("equirectangular_direction(vec2f(u, v))", &SCOPE, ["u", "v"], &points);
    let mut off = 0.0_f64;
    for ([u, v], row) in points.iter().zip(&rows) {
        let (azimuth, elevation) = (TAU * (f64::from(*u) - 0.5), PI * (f64::from(*v) - 0.5));
        let level = elevation.cos();
        let truth = [level * azimuth.sin(), elevation.sin(), -level * azimuth.cos()];
        off = off.max(distance(truth, [row[0], row[1], row[2]]));
    }
    let mut report = Report::new(SECTION, "a_panorama_is_even_in_azimuth_and_elevation");
    report.at_most("equirectangular: off the direction (rad)", off, 2e-6);
    report.finish();
}
