//! Curl noise and interleaved gradient noise.

use truth::noise::{curl2, curl3, gradient, interleaved_gradient};
use truth::points::{Random, worst2, worst3};

use crate::harness::{Report, Scope, values};
use crate::noise::at_places;

const SECTION: &str = "Noise: flow and dither";

#[test]
fn curl_noise_has_no_divergence() {
    let mut report = Report::new(SECTION, "curl_noise_has_no_divergence");
    let scope = Scope { includes: &["<noise/curl.wgsl>"], ..Scope::default() };
    let largest = |errors: &mut dyn Iterator<Item = f64>| errors.fold(0.0, f64::max);

    let points = Random::new(21).points::<2>(50_000, 100.0);
    let found = values("curl_noise2(p, 7u)", &scope, ["x", "y"], &points);
    let error = largest(&mut points.iter().zip(&found).map(|(p, row)| {
        let truth = curl2(p.map(f64::from), 7);
        (row[0] - truth[0]).abs().max((row[1] - truth[1]).abs())
    }));
    report.at_most("`curl_noise2`, against f64, relative to its bound", error / 2.9262, 1e-6);
    let longest = largest(&mut found.iter().map(|row| row[0].hypot(row[1])));
    report.at_most("`curl_noise2`, longest", longest, 2.9262);
    let divergence = largest(&mut points.iter().take(5_000).map(|p| {
        let along = |axis: usize| gradient(|q| curl2(q, 7)[axis], p.map(f64::from), 1e-4)[axis];
        (along(0) + along(1)).abs()
    }));
    report.at_most("`curl_noise2`, divergence in f64", divergence, 1e-5);

    let points = Random::new(22).points::<3>(50_000, 100.0);
    let found = values("curl_noise3(p, 7u)", &scope, ["x", "y", "z"], &points);
    let error = largest(&mut points.iter().zip(&found).map(|(p, row)| {
        let truth = curl3(p.map(f64::from), 7);
        largest(&mut (0..3).map(|axis| (row[axis] - truth[axis]).abs()))
    }));
    report.at_most("`curl_noise3`, against f64", error, 2e-6);
    let longest = largest(&mut found.iter().flatten().map(|part| part.abs()));
    report.at_most("`curl_noise3`, largest component", longest, 7.24);
    let divergence = largest(&mut points.iter().take(5_000).map(|p| {
        let along = |axis: usize| gradient(|q| curl3(q, 7)[axis], p.map(f64::from), 1e-4)[axis];
        (along(0) + along(1) + along(2)).abs()
    }));
    report.at_most("`curl_noise3`, divergence in f64", divergence, 1e-5);
    let file = "<noise/curl.wgsl>";
    let found = at_places::<2>("curl_noise2(p, 7u).x", file, 1_000_000, 1e4);
    let error = worst2(&found, 1e4, &|_, p| curl2(p, 7)[0]);
    report.at_most("`curl_noise2`, 1e6 points in ±1e4", error, 2e-6);
    let found = at_places::<3>("curl_noise3(p, 7u).x", file, 1_000_000, 1e4);
    let error = worst3(&found, 1e4, &|_, p| curl3(p, 7)[0]);
    report.at_most("`curl_noise3`, 1e6 points in ±1e4", error, 2e-6);
    report.finish();
}

#[test]
fn interleaved_gradient_noise_spreads_over_every_block() {
    let mut report = Report::new(SECTION, "interleaved_gradient_noise_spreads_over_every_block");
    let scope = Scope { includes: &["<noise/interleaved_gradient.wgsl>"], ..Scope::default() };
    let mut random = Random::new(23);
    let points: Vec<[f32; 3]> = (0..100_000)
        .map(|_| [random.within(0.0, 8192.0), random.within(0.0, 8192.0), (random.bits() % 64) as f32])
        .collect();
    let call = "interleaved_gradient_noise(vec2f(x, y), frame_index)";
    let found = values(call, &scope, ["x", "y", "frame_index:u32"], &points);
    let error = points
        .iter()
        .zip(&found)
        .map(|(&[x, y, frame], row)| {
            // Where the inner fraction returns to 0 the value jumps: a millionth either side counts as there.
            let apart = |nudge| {
                let apart = (row[0] - interleaved_gradient([x, y].map(f64::from), frame as u32, nudge)).abs();
                apart.min(1.0 - apart) // 0 and 1 are neighbours
            };
            [0.0, -1e-6, 1e-6].map(apart).into_iter().fold(1.0, f64::min)
        })
        .fold(0.0, f64::max);
    report.at_most(
        "`interleaved_gradient_noise`, against f64 over 8192 x 8192 pixels and 64 frames",
        error,
        1e-4,
    );
    let outside = found.iter().filter(|row| !(0.0..1.0).contains(&row[0])).count();
    report.at_most("`interleaved_gradient_noise`, places outside 0 <= value < 1", outside as f64, 0.0);

    // Sorted, the nine values of a block of 3 x 3 leave no gap much wider than 1/9.
    let side = 96;
    let pixels: Vec<[f32; 2]> = (0..side * side).map(|i| [(i % side) as f32, (i / side) as f32]).collect();
    let values = values("interleaved_gradient_noise(p, 0u)", &scope, ["x", "y"], &pixels);
    let mut widest = 0.0_f64;
    for y in 0..side - 2 {
        for x in 0..side - 2 {
            let mut block: Vec<f64> = (0..9).map(|i| values[(y + i / 3) * side + x + i % 3][0]).collect();
            block.sort_by(f64::total_cmp);
            let round = block[0] + 1.0 - block[8];
            widest = block.windows(2).map(|pair| pair[1] - pair[0]).fold(widest.max(round), f64::max);
        }
    }
    report.at_most(
        "`interleaved_gradient_noise`, widest gap between the values of 3 x 3 pixels",
        widest,
        0.2,
    );
    report.finish();
}
