//! Lattice noises: values, gradients and second derivatives, endless and tiled, across faces and at the wrap.

use std::f32::consts::{FRAC_1_SQRT_2, SQRT_2};

use truth::hash::pcg;
use truth::noise::{
    Period, gradient, hessian, perlin2, perlin3, perlin3_at, simplex2, simplex3, value2, value3,
};
use truth::points::{Random, worst2, worst3};

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Noise";

type Worst<const N: usize> = fn(&[f64], f32, &dyn Fn(u32, [f64; N]) -> f64) -> f64;

/// A noise of the plane (`N` = 2) or of space.
pub(crate) struct Noise<const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) file: &'static str,
    truth: fn([f64; N], Period<N>, u32) -> f64,
    /// [`worst2`] or [`worst3`].
    worst: Worst<N>,
    /// Where its values are held against f64.
    reach: f32,
    /// The most that it claims to be.
    pub(crate) range: f64,
    pub(crate) variance: f64,
    /// About its steepest slope: what errors of gradients are relative to.
    slope: f64,
    /// Normals of the planes that its pieces meet at, and how far apart parallel planes are, times the normals' length.
    faces: &'static [([f32; N], f32)],
}

const PLANE: [Noise<2>; 3] = [
    Noise {
        name: "value_noise2",
        file: "<noise/value.wgsl>",
        truth: value2,
        worst: worst2,
        reach: 1e4,
        range: 1.0,
        variance: 0.20465,
        slope: 3.75,
        faces: &[([1.0, 0.0], 1.0), ([0.0, 1.0], 1.0)],
    },
    Noise {
        name: "perlin_noise2",
        file: "<noise/perlin.wgsl>",
        truth: perlin2,
        worst: worst2,
        reach: 1e4,
        range: 1.0,
        variance: 0.304 * 0.304,
        slope: 2.92,
        faces: &[([1.0, 0.0], 1.0), ([0.0, 1.0], 1.0)],
    },
    Noise {
        name: "simplex_noise2",
        file: "<noise/simplex.wgsl>",
        truth: simplex2,
        worst: worst2,
        reach: 100.0,
        range: 0.98787,
        variance: 0.2837,
        slope: 7.25,
        // Rows, and the two other directions of the triangles' sides.
        faces: &[([0.0, 1.0], FRAC_1_SQRT_2), ([1.732_050_8, 1.0], SQRT_2), ([1.732_050_8, -1.0], SQRT_2)],
    },
];

const SPACE: [Noise<3>; 3] = [
    Noise {
        name: "value_noise3",
        file: "<noise/value.wgsl>",
        truth: value3,
        worst: worst3,
        reach: 1e4,
        range: 1.0,
        variance: 0.16035,
        slope: 3.75,
        faces: &[([1.0, 0.0, 0.0], 1.0), ([0.0, 1.0, 0.0], 1.0), ([0.0, 0.0, 1.0], 1.0)],
    },
    Noise {
        name: "perlin_noise3",
        file: "<noise/perlin.wgsl>",
        truth: perlin3,
        worst: worst3,
        reach: 1e4,
        range: 1.0,
        variance: 0.26 * 0.26,
        slope: 3.0,
        faces: &[([1.0, 0.0, 0.0], 1.0), ([0.0, 1.0, 0.0], 1.0), ([0.0, 0.0, 1.0], 1.0)],
    },
    Noise {
        name: "simplex_noise3",
        file: "<noise/simplex.wgsl>",
        truth: simplex3,
        worst: worst3,
        reach: 1e4,
        range: 0.98855,
        variance: 0.1505,
        slope: 5.0,
        faces: &[
            ([1.0, 1.0, 0.0], 1.0),
            ([0.0, 1.0, 1.0], 1.0),
            ([1.0, 0.0, 1.0], 1.0),
            ([1.0, -1.0, 0.0], 1.0),
            ([0.0, 1.0, -1.0], 1.0),
            ([1.0, 0.0, -1.0], 1.0),
        ],
    },
];

/// The six noises, each passed to the same check.
macro_rules! for_each_noise {
    ($check:ident, $report:expr) => {
        PLANE.iter().for_each(|noise| $check(noise, $report));
        SPACE.iter().for_each(|noise| $check(noise, $report));
    };
}

pub(crate) fn plane() -> &'static [Noise<2>] {
    &PLANE
}

pub(crate) fn space() -> &'static [Noise<3>] {
    &SPACE
}

const AXES: [&str; 3] = ["x", "y", "z"];

fn axes<const N: usize>() -> [&'static str; N] {
    std::array::from_fn(|axis| AXES[axis])
}

fn widened<const N: usize>(p: &[f32; N]) -> [f64; N] {
    p.map(f64::from)
}

fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    errors.fold(0.0, |most, error| if error.is_nan() { f64::NAN } else { most.max(error) })
}

/// `expression` at `count` places `p` of [`place2`] or [`place3`], `index` being their number; four to an invocation, since what is
/// slow is carrying numbers over.
pub(crate) fn at_places<const N: usize>(expression: &str, file: &str, count: u32, reach: f32) -> Vec<f64> {
    let bits = if N == 2 { "pcg2d(vec2u(index, 77u))" } else { "pcg3d(vec3u(index, 77u, 78u))" };
    let fragment = format!(
        "#include {file}
#include <noise/pcg.wgsl>
fn equal(a: f32, b: f32) -> f32 {{
    return select(9.0, a, a == b);
}}
fn one_of(index: u32) -> u32 {{
    var periods = array<u32, {count}>({periods});
    return periods[pcg(index) % {count}u];
}}
fn four(first: u32) -> vec4f {{
    var found = vec4f(0.0);
    for (var k = 0u; k < 4u; k++) {{
        let index = 4u * first + k;
        let p = (unit_float{N}({bits}) * 2.0 - 1.0) * {reach:?};
        found[k] = {expression};
    }}
    return found;
}}",
        count = PERIODS.len(),
        periods = PERIODS.map(|period| format!("{period}u")).join(", "),
    );
    let scope = Scope { fragment: &fragment, ..Scope::default() };
    let firsts: Vec<[f32; 1]> = (0..count / 4).map(|first| [first as f32]).collect();
    values("four(i)", &scope, ["i:u32"], &firsts).concat()
}

#[test]
fn noises_equal_f64_at_a_million_points() {
    fn check<const N: usize>(noise: &Noise<N>, report: &mut Report) {
        let Noise { name, file, truth, worst, reach, .. } = noise;
        let both = format!("equal({name}(p, 7u), {name}_grad(p, 7u).x)");
        let error = |count, reach| {
            let found = at_places::<N>(&both, file, count, reach);
            assert_eq!(found.len(), count as usize);
            worst(&found, reach, &|_, p| truth(p, None, 7))
        };
        report.at_most(&format!("`{name}`, 1e6 points in ±{reach}"), error(1_000_000, *reach), 2e-6);
        report.at_most(&format!("`{name}`, 1e5 points in ±8"), error(100_000, 8.0), 2e-6);
        if *reach < 1e4 {
            report.told(&format!("`{name}`, 1e5 points in ±1e4"), error(100_000, 1e4));
            report.told(&format!("`{name}`, 1e5 points in ±1e6"), error(100_000, 1e6));
        }
    }
    let mut report = Report::new(SECTION, "noises_equal_f64_at_a_million_points");
    for_each_noise!(check, &mut report);
    report.finish();
}

/// Every axis with each of these, in all mixtures.
const PERIODS: [u32; 7] = [1, 2, 3, 7, 289, 1000, 65_537];

#[test]
fn tiled_noises_equal_f64_at_a_million_points() {
    fn check<const N: usize>(noise: &Noise<N>, report: &mut Report) {
        let Noise { name, file, truth, worst, reach, .. } = noise;
        let period =
            (0..N).map(|axis| format!("one_of({N}u * index + {axis}u)")).collect::<Vec<_>>().join(", ");
        let tiled = format!("{name}_tiled(p, vec{N}u({period}), 7u).x");
        let found = at_places::<N>(&tiled, file, 1_000_000, *reach);
        let error = worst(&found, *reach, &|index, p| {
            let one_of = |axis| PERIODS[pcg(N as u32 * index + axis as u32) as usize % PERIODS.len()];
            truth(p, Some(std::array::from_fn(one_of)), 7)
        });
        report.at_most(&format!("`{name}_tiled`, 1e6 points in ±{reach}"), error, 2e-6);
    }
    let mut report = Report::new(SECTION, "tiled_noises_equal_f64_at_a_million_points");
    for_each_noise!(check, &mut report);
    report.finish();
}

#[test]
fn analytic_gradients_equal_differences() {
    fn check<const N: usize>(noise: &Noise<N>, report: &mut Report) {
        let Noise { name, file, truth, slope, .. } = noise;
        let scope = Scope { includes: &[file], ..Scope::default() };
        let points = Random::new(3).points::<N>(30_000, 16.0);
        let period: [u32; N] = std::array::from_fn(|axis| [5, 7, 3][axis]);
        let list: Vec<String> = period.iter().map(|count| format!("{count}u")).collect();
        let tiled = format!("{name}_tiled(p, vec{N}u({}), 7u)", list.join(", "));
        for (expression, what, period) in
            [(format!("{name}_grad(p, 7u)"), "_grad", None), (tiled, "_tiled", Some(period))]
        {
            let found = values(&expression, &scope, axes(), &points);
            let error = largest(points.iter().zip(&found).map(|(p, row)| {
                let differences = gradient(|q| truth(q, period, 7), widened(p), 1e-5);
                largest((0..N).map(|axis| (row[1 + axis] - differences[axis]).abs()))
            }));
            report.at_most(&format!("`{name}{what}`, relative to the largest slope"), error / slope, 1e-3);
        }
    }
    let mut report = Report::new(SECTION, "analytic_gradients_equal_differences");
    for_each_noise!(check, &mut report);
    report.finish();
}

#[test]
fn analytic_second_derivatives_equal_differences() {
    let mut report = Report::new(SECTION, "analytic_second_derivatives_equal_differences");
    for (Noise { name, file, truth, .. }, curvature) in PLANE.iter().zip([14.06, 13.06, 55.1]) {
        let scope = Scope { includes: &[file], ..Scope::default() };
        let points = Random::new(4).points::<2>(50_000, 16.0);
        let found = values(&format!("{name}_jet(p, 7u)"), &scope, axes(), &points);
        let error = largest(points.iter().zip(&found).map(|(p, row)| {
            let differences = hessian(|q| truth(q, None, 7), widened(p), 1e-4);
            largest((0..3).map(|part| (row[3 + part] - differences[part]).abs()))
        }));
        report.at_most(&format!("`{name}_jet`, relative to the largest curvature"), error / curvature, 1e-3);
        let expression = format!(
            "dot(abs(vec3f({name}_jet(p, 7u).value, {name}_jet(p, 7u).gradient) - {name}_grad(p, 7u)), vec3f(1.0))"
        );
        let apart = largest(values(&expression, &scope, axes(), &points).iter().map(|row| row[0]));
        report.at_most(&format!("`{name}_jet` against `{name}_grad`"), apart, 1e-6);
    }
    report.finish();
}

#[test]
fn noises_are_continuous_across_faces() {
    fn check<const N: usize>(noise: &Noise<N>, report: &mut Report) {
        let Noise { name, file, faces, .. } = noise;
        let mut random = Random::new(5);
        // Pairs of places either side of a face, as near to it as f32 allows.
        let mut points: Vec<[f32; N]> = Vec::new();
        for index in 0..60_000 {
            let (normal, spacing) = faces[index % faces.len()];
            let p: [f32; N] = random.point(8.0);
            let normal = normal.map(f64::from);
            let (length2, height) = (0..N).fold((0.0, 0.0), |sum, axis| {
                (sum.0 + normal[axis] * normal[axis], sum.1 + normal[axis] * f64::from(p[axis]))
            });
            let face = (height / f64::from(spacing)).round() * f64::from(spacing);
            for side in [-5e-7, 5e-7] {
                points.push(std::array::from_fn(|axis| {
                    (f64::from(p[axis]) + normal[axis] * ((face - height) / length2 + side)) as f32
                }));
            }
        }
        let scope = Scope { includes: &[file], ..Scope::default() };
        let found = values(&format!("{name}_grad(p, 7u)"), &scope, axes(), &points);
        let (mut jump, mut kink) = (0.0_f64, 0.0_f64);
        for (p, row) in points.chunks_exact(2).zip(found.chunks_exact(2)) {
            let along: f64 = (0..N)
                .map(|axis| {
                    0.5 * (row[0][1 + axis] + row[1][1 + axis])
                        * (f64::from(p[1][axis]) - f64::from(p[0][axis]))
                })
                .sum();
            jump = jump.max((row[1][0] - row[0][0] - along).abs());
            kink = kink.max(largest((0..N).map(|axis| (row[1][1 + axis] - row[0][1 + axis]).abs())));
        }
        report.at_most(&format!("`{name}`, jump of the value beyond its slope's"), jump, 1e-6);
        report.at_most(&format!("`{name}`, jump of a derivative within 2e-6"), kink, 1.2e-4);
    }
    let mut report = Report::new(SECTION, "noises_are_continuous_across_faces");
    for_each_noise!(check, &mut report);
    report.finish();
}

#[test]
fn tiled_noises_repeat_bit_for_bit() {
    let mut report = Report::new(SECTION, "tiled_noises_repeat_bit_for_bit");
    let tiled: Vec<(&str, &str, usize, &str)> = vec![
        ("value_noise2_tiled", "<noise/value.wgsl>", 2, "vec4f(n, 0.0)"),
        ("perlin_noise2_tiled", "<noise/perlin.wgsl>", 2, "vec4f(n, 0.0)"),
        ("simplex_noise2_tiled", "<noise/simplex.wgsl>", 2, "vec4f(n, 0.0)"),
        ("worley_noise2_tiled", "<noise/worley.wgsl>", 2, "vec4f(n.f1, n.f2, n.offset.x, f32(n.id >> 8u))"),
        ("value_noise3_tiled", "<noise/value.wgsl>", 3, "n"),
        ("perlin_noise3_tiled", "<noise/perlin.wgsl>", 3, "n"),
        ("simplex_noise3_tiled", "<noise/simplex.wgsl>", 3, "n"),
        ("worley_noise3_tiled", "<noise/worley.wgsl>", 3, "vec4f(n.f1, n.f2, n.offset.x, f32(n.id >> 8u))"),
        ("perlin_worley3_tiled", "<noise/perlin_worley.wgsl>", 3, "vec4f(n)"),
    ];
    for (name, file, dimension, parts) in tiled {
        let cut = if dimension == 2 { ".xy" } else { "" };
        let list: Vec<String> = PERIODS.iter().map(|period| format!("{period}u")).collect();
        // Places in 1/64 around the seams and around the origin, moved by a period each way: exact in f32.
        let fragment = format!(
            "#include {file}
fn told(p: vec3f, period: vec3u) -> vec4f {{
    let n = {name}(p{cut}, period{cut}, 7u);
    return {parts};
}}
fn broken(i: u32) -> u32 {{
    var periods = array<u32, {count}>({list});
    var count = 0u;
    for (var k = 0u; k < 200u; k++) {{
        let dice = pcg3d(vec3u(i, k, 5u)) >> vec3u(8u);
        let period = vec3u(periods[dice.x % {count}u], periods[dice.y % {count}u], periods[dice.z % {count}u]);
        let seam = vec3f(vec3i((dice >> vec3u(3u)) % vec3u(3u)) - 1) * vec3f(period);
        let p = (vec3f((dice >> vec3u(5u)) % vec3u(513u)) - 256.0) / 64.0 + seam;
        let moved = p + vec3f(vec3i((dice >> vec3u(17u)) % vec3u(3u)) - 1) * vec3f(period);
        var bits: array<vec4u, 2>;
        for (var side = 0u; side < 2u; side++) {{
            bits[side] = bitcast<vec4u>(told(select(p, moved, side == 1u), period));
        }}
        let same = bits[0] == bits[1];
        count += select(1u, 0u, all(same));
    }}
    return count;
}}",
            count = PERIODS.len(),
            list = list.join(", "),
        );
        let scope = Scope { includes: &["<noise/pcg.wgsl>"], fragment: &fragment, ..Scope::default() };
        let invocations: Vec<[f32; 1]> = (0..1000).map(|i| [i as f32]).collect();
        let broken: f64 = values("broken(i)", &scope, ["i:u32"], &invocations).iter().map(|row| row[0]).sum();
        report.at_most(&format!("`{name}`, places of 2e5 that differ a period on"), broken, 0.0);
    }
    report.finish();
}

#[test]
fn perlin_noise_stays_smooth_a_million_cells_away() {
    let mut report = Report::new(SECTION, "perlin_noise_stays_smooth_a_million_cells_away");
    let scope = Scope { includes: &["<noise/perlin.wgsl>"], ..Scope::default() };
    let mut random = Random::new(6);
    // Cells around ±1e6 and ±1e9, fractions that leave 0 .. 1.
    let points: Vec<[f32; 6]> = (0..100_000)
        .map(|index| {
            let far = if index % 2 == 0 { 1e6 } else { 1e9 };
            std::array::from_fn(|part| match part {
                0..3 => random.within(-far, far).floor(),
                _ => random.within(-2.5, 2.5),
            })
        })
        .collect();
    let columns = ["i:i32", "j:i32", "k:i32", "u", "v", "w"];
    let there = "vec3i(i, j, k), vec3f(u, v, w), 7u";
    let found = values(&format!("perlin_noise3_at_grad({there})"), &scope, columns, &points);
    let plain = values(&format!("perlin_noise3_at({there})"), &scope, columns, &points);
    let (mut value, mut slope) = (0.0_f64, 0.0_f64);
    for ((row, found), plain) in points.iter().zip(&found).zip(&plain) {
        let cell = [0, 1, 2].map(|axis| row[axis] as i64);
        let truth = |fraction| perlin3_at(cell, fraction, None, 7);
        let fraction = [3, 4, 5].map(|part| f64::from(row[part]));
        let expected = truth(fraction);
        value = value.max((found[0] - expected).abs()).max((plain[0] - expected).abs());
        let differences = gradient(truth, fraction, 1e-5);
        slope = slope.max(largest((0..3).map(|axis| (found[1 + axis] - differences[axis]).abs())));
    }
    report.at_most("`perlin_noise3_at`, cells up to ±1e9, against f64", value, 2e-6);
    report.at_most("`perlin_noise3_at_grad`, relative to the largest slope", slope / 3.0, 1e-3);

    let near = Random::new(7).points::<3>(100_000, 100.0);
    let same = "u32(perlin_noise3_at(vec3i(floor(p)), fract(p), 7u) != perlin_noise3(p, 7u))";
    let different: f64 = values(same, &scope, ["x", "y", "z"], &near).iter().map(|row| row[0]).sum();
    report.at_most("places of 1e5 near the origin where it is not `perlin_noise3`", different, 0.0);

    // Across a face: the end of one cell and the start of the next.
    let across = "abs(perlin_noise3_at(vec3i(i, j, k), vec3f(0.99999994, v, w), 7u) \
                  - perlin_noise3_at(vec3i(i + 1, j, k), vec3f(0.0, v, w), 7u))";
    let jump = largest(values(across, &scope, columns, &points).iter().map(|row| row[0]));
    report.at_most("`perlin_noise3_at`, jump from .99999994 of a cell to the next", jump, 1e-6);
    report.finish();
}
