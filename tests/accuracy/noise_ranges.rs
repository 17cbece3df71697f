//! Ranges, variances, and the suprema that marches rely on.

use truth::noise::bounds;

use crate::harness::{Report, Scope, values};
use crate::noise::{plane, space};

const SECTION: &str = "Noise: ranges";

/// Least, largest, mean and variance of `expression` at 1e7 places `p` (vec3f), each of 1e4 seeds `i` at 1e3.
fn statistics(expression: &str, includes: &[&str]) -> [f64; 4] {
    let includes: Vec<String> = includes.iter().map(|file| format!("#include {file}\n")).collect();
    let fragment = format!(
        "{}
fn statistics(i: u32) -> vec4f {{
    var least = 1e9;
    var most = -1e9;
    var sum = vec2f(0.0);
    for (var k = 0u; k < 1000u; k++) {{
        let p = (unit_float3(pcg3d(vec3u(i, k, 1u))) - 0.5) * 128.0;
        let n = {expression};
        least = min(least, n);
        most = max(most, n);
        sum += vec2f(n, n * n);
    }}
    return vec4f(least, most, sum);
}}",
        includes.concat()
    );
    let scope = Scope { includes: &["<noise/pcg.wgsl>"], fragment: &fragment, ..Scope::default() };
    let seeds: Vec<[f32; 1]> = (0..10_000).map(|seed| [seed as f32]).collect();
    let found = values("statistics(i)", &scope, ["i:u32"], &seeds);
    let (mut least, mut most, mut sum, mut squares) = (f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0);
    for row in &found {
        (least, most) = (least.min(row[0]), most.max(row[1]));
        (sum, squares) = (sum + row[2], squares + row[3]);
    }
    let mean = sum / 1e7;
    [least, most, mean, squares / 1e7 - mean * mean]
}

#[test]
fn noises_keep_their_ranges_and_variances() {
    let mut report = Report::new(SECTION, "noises_keep_their_ranges_and_variances");
    let plane = plane()
        .iter()
        .map(|noise| (noise.name, noise.file, noise.range, noise.variance, ".xy", "vec2u(3u, 8u)"));
    let space = space()
        .iter()
        .map(|noise| (noise.name, noise.file, noise.range, noise.variance, "", "vec3u(3u, 8u, 5u)"));
    for (name, file, range, variance, cut, period) in plane.chain(space) {
        let [least, most, _, measured] = statistics(&format!("{name}(p{cut}, i)"), &[file]);
        report.at_most(&format!("`{name}`, largest of 1e7"), most.max(-least), range);
        report.near(&format!("`{name}`, variance"), measured, variance, 0.02 * variance);
        let [least, most, ..] = statistics(&format!("{name}_tiled(p{cut}, {period}, i).x"), &[file]);
        report.at_most(&format!("`{name}_tiled`, largest of 1e7"), most.max(-least), range);
    }
    report.finish();
}

#[test]
fn ranges_are_the_suprema() {
    let mut report = Report::new(SECTION, "ranges_are_the_suprema");
    let turn = std::f64::consts::PI;
    let constants = |name: &str, file| {
        let expression = format!("vec3f({name}_RANGE, {name}_SLOPE, {name}_CURVATURE)");
        crate::harness::value(&expression, &Scope { includes: &[file], ..Scope::default() })
    };
    for (name, file, reach) in [
        ("VALUE_NOISE2", "<noise/value.wgsl>", bounds::value as bounds::Reach),
        ("PERLIN_NOISE2", "<noise/perlin.wgsl>", bounds::perlin),
        ("SIMPLEX_NOISE2", "<noise/simplex.wgsl>", bounds::simplex),
    ] {
        let promised = constants(name, file);
        for (order, what) in ["RANGE", "SLOPE", "CURVATURE"].iter().enumerate() {
            let supremum = bounds::largest(|at| reach(at)[order], turn);
            let over = promised[order] / supremum - 1.0;
            report.told(&format!("supremum that `{name}_{what}` bounds"), supremum);
            report.at_least(&format!("`{name}_{what}` over it, relative"), over, -1e-12);
            report.at_most(&format!("`{name}_{what}` over it, relative"), over, 2e-4);
        }
    }
    report.near("`perlin_noise3`, supremum", bounds::largest(bounds::perlin3, 1.0), 0.99957, 1e-5);
    let along = bounds::largest(bounds::perlin3_along_x, 1.0);
    report.at_most("`curl_noise3`, a component's bound: two derivatives of Perlin noise", 2.0 * along, 7.24);
    report.near("`simplex_noise3`, supremum", bounds::largest(bounds::simplex3, 1.0), 0.98854, 1e-5);
    report.finish();
}

#[test]
fn no_sample_is_steeper_or_more_curved_than_promised() {
    let mut report = Report::new(SECTION, "no_sample_is_steeper_or_more_curved_than_promised");
    for (name, file) in [
        ("value_noise2", "<noise/value.wgsl>"),
        ("perlin_noise2", "<noise/perlin.wgsl>"),
        ("simplex_noise2", "<noise/simplex.wgsl>"),
    ] {
        let constant = name.to_uppercase();
        let [_, steepest, ..] =
            statistics(&format!("length({name}_grad(p.xy, i).yz) / {constant}_SLOPE"), &[file]);
        report.at_most(&format!("`{name}`, steepest of 1e7, relative to its bound"), steepest, 1.0);
        // The larger eigenvalue: half the trace and half the difference.
        let curved = format!("curvature({name}_jet(p.xy, i).hessian) / {constant}_CURVATURE");
        let helper = "\nfn curvature(h: vec3f) -> f32 {
    return 0.5 * (abs(h.x + h.z) + length(vec2f(h.x - h.z, 2.0 * h.y)));
}";
        let [_, curvest, ..] = statistics(&curved, &[&format!("{file}{helper}")]);
        report.at_most(&format!("`{name}`, most curved of 1e7, relative to its bound"), curvest, 1.0);
    }
    report.finish();
}
