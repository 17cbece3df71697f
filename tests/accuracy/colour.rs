//! Colours that stand for numbers.

use truth::oklab::oklab;
use truth::points::Random;

use crate::harness::{Report, Scope, values};

#[test]
fn heat_is_as_light_as_it_is_hot() {
    let scope = Scope { includes: &["<color/heat.wgsl>"], ..Scope::default() };
    let parts: Vec<[f32; 1]> = (0..=1000).map(|i| [i as f32 / 1000.0]).collect();
    let colors = values("heat_color(part)", &scope, ["part"], &parts);
    let labs: Vec<[f64; 3]> = colors.iter().map(|c| oklab([c[0], c[1], c[2]])).collect();
    let mut report = Report::new("Colour", "heat_is_as_light_as_it_is_hot");
    let off = labs.iter().zip(&parts).map(|(lab, part)| (lab[0] - (0.20 + 0.76 * f64::from(part[0]))).abs());
    report.at_most("`heat_color`: lightness off the line 0.20 to 0.96", off.fold(0.0, f64::max), 1e-5);
    // Were a colour outside of sRGB, it would be clipped, and its channels exactly 0 or 1.
    let scalars = || colors.iter().flatten().copied();
    report.at_least("`heat_color`: the least channel", scalars().fold(1.0, f64::min), 1e-4);
    report.at_most("`heat_color`: the greatest channel", scalars().fold(0.0, f64::max), 0.999);
    let step = |pair: &[[f64; 3]]| (0..3).map(|i| (pair[1][i] - pair[0][i]).powi(2)).sum::<f64>().sqrt();
    let steps: Vec<f64> = labs.windows(2).map(step).collect();
    let ratio = steps.iter().copied().fold(0.0, f64::max) / steps.iter().copied().fold(1.0, f64::min);
    report.at_most("`heat_color`: the greatest step of colour over the least", ratio, 1.1);
    report.finish();
}

#[test]
fn oklab_is_there_and_back_again() {
    let scope = Scope { includes: &["<color/oklab.wgsl>"], ..Scope::default() };
    let mut random = Random::new(3);
    let colors: Vec<[f32; 3]> = (0..100_000).map(|_| [0; 3].map(|_| random.within(0.0, 1.0))).collect();
    let labs = values("oklab_from_linear(p)", &scope, ["x", "y", "z"], &colors);
    let back = values("oklab_to_linear(oklab_from_linear(p))", &scope, ["x", "y", "z"], &colors);
    let (mut off, mut lost) = (0.0_f64, 0.0_f64);
    for ((color, lab), back) in colors.iter().zip(&labs).zip(&back) {
        let exact = oklab(color.map(f64::from));
        off = (0..3).map(|i| (lab[i] - exact[i]).abs()).fold(off, f64::max);
        lost = (0..3).map(|i| (back[i] - f64::from(color[i])).abs()).fold(lost, f64::max);
    }
    let mut report = Report::new("Colour", "oklab_is_there_and_back_again");
    report.at_most("`oklab_from_linear` against f64", off, 5e-6);
    report.at_most("`oklab_to_linear` of `oklab_from_linear`", lost, 2e-5);
    report.finish();
}
