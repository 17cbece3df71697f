//! Phase functions: whole, as lopsided as is said, right in their peaks, finite at their ends.

use truth::phase as exact;

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Light";

const SCOPE: Scope<'_> = Scope { includes: &["<light/phase.wgsl>"], fragment: "", preset: None };

/// The GPU's `call`, a function of `c`, at all of `cosines`.
fn curve(call: &str, cosines: &[f32]) -> Vec<f64> {
    let points: Vec<[f32; 1]> = cosines.iter().map(|&c| [c]).collect();
    values(call, &SCOPE, ["c"], &points).into_iter().map(|v| v[0]).collect()
}

/// For each setting: the call, its mean cosine, its values in f64.
type Setting = (String, f64, Box<dyn Fn(f64) -> f64>);

fn hold(report: &mut Report, name: &str, settings: Vec<Setting>) {
    hold_to(report, name, settings, 1e-5);
}

fn hold_to(report: &mut Report, name: &str, settings: Vec<Setting>, error: f64) {
    let cosines = exact::crowded_cosines();
    let (mut whole, mut mean, mut off) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (call, stated, truth) in settings {
        let got = curve(&call, &cosines);
        let [sum, first] = exact::over_the_sphere(&cosines, &got);
        whole = whole.max((sum - 1.0).abs());
        mean = mean.max((first - stated).abs());
        for (c, v) in cosines.iter().zip(&got) {
            off = off.max((v / truth(f64::from(*c)) - 1.0).abs());
        }
    }
    report.at_most(&format!("{name}: integral over the sphere off 1"), whole, 1e-4);
    report.at_most(&format!("{name}: mean cosine off the stated one"), mean, 1e-3);
    report.at_most(&format!("{name}: relative error at 12,000 angles"), off, error);
}

/// Anisotropies from -.95 to .95.
const GS: [f32; 13] = [-0.95, -0.9, -0.8, -0.5, -0.3, -0.1, 0.0, 0.1, 0.3, 0.5, 0.8, 0.9, 0.95];

#[test]
fn phase_functions_are_whole_and_as_lopsided_as_is_said() {
    let mut report = Report::new(SECTION, "phase_functions_are_whole_and_as_lopsided_as_is_said");
    let level = 0.25 / std::f64::consts::PI;
    let isotropic: Setting = ("phase_isotropic() + 0.0 * c".to_owned(), 0.0, Box::new(move |_| level));
    hold(&mut report, "Isotropic", vec![isotropic]);
    let rayleigh: Setting =
        ("phase_rayleigh(c)".to_owned(), 0.0, Box::new(move |c| 0.75 * level * (1.0 + c * c)));
    hold(&mut report, "Rayleigh", vec![rayleigh]);

    let each =
        |setting: &dyn Fn(f32, f64) -> Setting| GS.map(|g| setting(g, f64::from(g))).into_iter().collect();
    let hg = each(&|g, w| {
        (format!("phase_henyey_greenstein(c, {g:?})"), w, Box::new(move |c| exact::henyey_greenstein(c, w)))
    });
    hold(&mut report, "Henyey-Greenstein, g -.95 .. .95", hg);
    let cornette_shanks = each(&|g, w| {
        let mean = 3.0 * w * (4.0 + w * w) / (5.0 * (2.0 + w * w));
        (format!("phase_cornette_shanks(c, {g:?})"), mean, Box::new(move |c| exact::draine(c, w, 1.0)))
    });
    hold(&mut report, "Cornette-Shanks, g -.95 .. .95", cornette_shanks);
    let schlick = each(&|g, w| {
        let k = (1.55 * w - 0.55 * w.powi(3)).clamp(-0.999, 0.999);
        (format!("phase_schlick(c, {g:?})"), exact::schlick_mean(k), Box::new(move |c| exact::schlick(c, k)))
    });
    hold(&mut report, "Schlick, g -.95 .. .95", schlick);
    let two_lobe = [(0.8_f32, -0.3_f32, 0.85_f32), (0.7, -0.2, 0.5), (0.95, -0.5, 0.0), (0.95, -0.5, 1.0)];
    let two_lobe = two_lobe.map(|(forward, back, share)| -> Setting {
        let [f, b, s] = [forward, back, share].map(f64::from);
        let truth = move |c| s * exact::henyey_greenstein(c, f) + (1.0 - s) * exact::henyey_greenstein(c, b);
        let call = format!("phase_two_lobe(c, {forward:?}, {back:?}, {share:?})");
        (call, s * f + (1.0 - s) * b, Box::new(truth))
    });
    hold(&mut report, "Two lobes", two_lobe.into_iter().collect());
    let draine = [(0.5_f32, 20.0_f32), (-0.6, 3.0), (0.63, 32.0), (0.95, 250.0), (0.3, 0.0)];
    let draine = draine.map(|(g, alpha)| -> Setting {
        let (w, a) = (f64::from(g), f64::from(alpha));
        let call = format!("phase_draine(c, {g:?}, {alpha:?})");
        (call, exact::draine_mean(w, a), Box::new(move |c| exact::draine(c, w, a)))
    });
    hold(&mut report, "Draine", draine.into_iter().collect());
    let droplets = [5.0_f32, 8.0, 12.0, 20.0, 35.0, 50.0].map(|diameter| -> Setting {
        let d = f64::from(diameter);
        let call = format!("phase_hg_draine(c, {diameter:?})");
        (call, exact::hg_draine_mean(d), Box::new(move |c| exact::hg_draine(c, d)))
    });
    // Its g, up to .998, is an f32: 1 - g has five digits.
    hold_to(&mut report, "HG + Draine, droplets of 5 .. 50 um", droplets.into_iter().collect(), 3e-5);
    report.finish();
}

#[test]
fn phase_functions_stay_finite_whatever_the_anisotropy() {
    let calls = [
        "phase_henyey_greenstein(c, g)",
        "phase_two_lobe(c, g, -g, 0.5)",
        "phase_cornette_shanks(c, g)",
        "phase_schlick(c, g)",
        "phase_draine(c, g, 30.0)",
        "phase_hg_draine(c, 50.0 * g)",
    ];
    let mut points = Vec::new();
    for c in [-1.000_001_f32, -1.0, -0.5, 0.0, 0.5, 0.999_999, 1.0, 1.000_001] {
        for g in [-1e9_f32, -1.0, -0.999_999, -0.99, 0.0, 0.94, 0.97, 0.99, 0.999_999, 1.0, 1e9] {
            points.push([c, g]);
        }
    }
    let mut report = Report::new(SECTION, "phase_functions_stay_finite_whatever_the_anisotropy");
    for call in calls {
        let got = values(call, &SCOPE, ["c", "g"], &points);
        let wrong = got.iter().filter(|v| !v[0].is_finite() || v[0] < 0.0).count();
        report.at_most(&format!("{call}: not finite or negative, 8 cosines × 11 g"), wrong as f64, 0.0);
    }
    report.finish();
}
