//! Fresnel, highlights, occlusion, rough mirrors.

use truth::light as exact;
use truth::points::Random;

use crate::harness::{Report, Scope, value, values};

const SECTION: &str = "Light";

/// `reference/fresnel.json`: air to water, n = 1.333.
pub(crate) const FRESNEL: [(f64, f64); 5] = [
    (0.0, 0.020_373_187_8),
    (45.0, 0.027_898_364_6),
    (60.0, 0.059_690_919_2),
    (75.0, 0.212_377_583),
    (85.0, 0.583_523_479),
];

#[test]
fn fresnel_is_exact() {
    let scope = Scope { includes: &["<light/fresnel.wgsl>"], ..Scope::default() };
    let mut report = Report::new(SECTION, "fresnel_is_exact");
    let cosines: Vec<[f32; 1]> = FRESNEL.iter().map(|row| [row.0.to_radians().cos() as f32]).collect();
    let got = values("fresnel_dielectric(c, 1.333)", &scope, ["c"], &cosines);
    let off = FRESNEL.iter().zip(&got).map(|(row, v)| (row.1 - v[0]).abs()).fold(0.0, f64::max);
    report.at_most("water: off reference/fresnel.json", off, 1e-5);

    let cosines: Vec<[f32; 1]> = (0..=20_000).map(|i| [i as f32 / 20_000.0]).collect();
    for ior in [1.333_f32, 0.75, 1.5, 2.42, 1.0] {
        let got = values(&format!("fresnel_dielectric(c, {ior:?})"), &scope, ["c"], &cosines);
        let mut off: f64 = 0.0;
        for (c, v) in cosines.iter().zip(&got) {
            assert!((0.0..=1.0).contains(&v[0]), "reflectance {} at cosine {}", v[0], c[0]);
            let angle = f64::from(c[0]).acos();
            // Near the critical angle the curve is upright: the input's own rounding moves it.
            if angle < 1.570 && (angle.sin() / f64::from(ior) - 1.0).abs() > 3e-4 {
                off = off.max((v[0] - exact::fresnel(angle, f64::from(ior))).abs());
            }
        }
        report.at_most(&format!("index {ior}: off Fresnel's equations at 20,000 angles"), off, 1e-5);
    }
    let critical = (0.75_f64 * 0.75).mul_add(-1.0, 1.0).sqrt();
    let inside: Vec<[f32; 1]> = (0..1000).map(|i| [(critical * f64::from(i) / 1000.0) as f32]).collect();
    let total = values("fresnel_dielectric(c, 0.75)", &scope, ["c"], &inside);
    let least = total.iter().map(|v| v[0]).fold(1.0, f64::min);
    report.near("past the critical angle (water to air, 48.6°): least reflectance", least, 1.0, 0.0);
    report.finish();
}

#[test]
fn schlick_errs_as_is_said() {
    let scope = Scope { includes: &["<light/fresnel.wgsl>"], ..Scope::default() };
    let cosines: Vec<[f32; 1]> = (1..=9_000).map(|i| [(f64::from(i) / 9_000.0) as f32]).collect();
    let got = values("fresnel_schlick(c, vec3f(fresnel_normal(1.333)))", &scope, ["c"], &cosines);
    let (mut relative, mut absolute) = (0.0_f64, 0.0_f64);
    for (c, v) in cosines.iter().zip(&got) {
        let truth = exact::fresnel(f64::from(c[0]).acos(), f64::from(1.333_f32));
        relative = relative.max((v[0] / truth - 1.0).abs());
        absolute = absolute.max((v[0] - truth).abs());
    }
    let mut report = Report::new(SECTION, "schlick_errs_as_is_said");
    report.at_most("Schlick for water: relative error", relative, 0.23);
    report.at_most("Schlick for water: error", absolute, 0.06);
    report.finish();
}

#[test]
fn surfaces_reflect_no_more_than_they_get() {
    // The whole hemisphere summed on the GPU: albedo of light that comes in at `angle`. (lavapipe ends all loops of a
    // shader after 65,535 turns.)
    let fragment = "
        #include <light/brdf.wgsl>
        fn albedo(angle: f32, shininess: f32, kind: u32) -> f32 {
            let to_light = vec3f(sin(angle), cos(angle), 0.0);
            var sum = 0.0;
            for (var i = 0; i < 180; i++) {
                let theta = (f32(i) + 0.5) * 1.5707963 / 180.0;
                var ring = 0.0;
                for (var j = 0; j < 320; j++) {
                    let phi = (f32(j) + 0.5) * 6.2831853 / 320.0;
                    let eye = vec3f(sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi));
                    if kind == 0u {
                        ring += lambert_brdf(vec3f(0.5)).x;
                    } else if kind == 1u {
                        ring += phong_brdf(vec3f(0.0, 1.0, 0.0), to_light, eye, shininess);
                    } else {
                        ring += blinn_phong_brdf(vec3f(0.0, 1.0, 0.0), to_light, eye, shininess);
                    }
                }
                sum += ring * cos(theta) * sin(theta);
            }
            return sum * (1.5707963 / 180.0) * (6.2831853 / 320.0);
        }";
    let scope = Scope { fragment, ..Scope::default() };
    let angles: Vec<f32> = (0..16).map(|i| i as f32 * 0.1).collect();
    let mut report = Report::new(SECTION, "surfaces_reflect_no_more_than_they_get");
    for (name, kind, upright) in [("Lambert, albedo .5", 0, 0.5), ("Phong", 1, 1.0), ("Blinn-Phong", 2, 1.0)]
    {
        let rows: Vec<[f32; 3]> = angles
            .iter()
            .flat_map(|&angle| {
                [0.0_f32, 1.0, 5.0, 30.0, 200.0].map(|shininess| [angle, shininess, kind as f32])
            })
            .collect();
        let got = values("albedo(angle, shininess, kind)", &scope, ["angle", "shininess", "kind:u32"], &rows);
        let most = got.iter().map(|v| v[0]).fold(0.0, f64::max);
        report.at_most(
            &format!("{name}: most that is reflected, 16 angles × 5 shininesses"),
            most,
            upright + 2e-3,
        );
        let normal = rows.iter().zip(&got).filter(|(row, _)| row[0] == 0.0);
        let off = normal.map(|(_, v)| (v[0] - upright).abs()).fold(0.0, f64::max);
        report.at_most(&format!("{name}: off {upright} for light along the normal"), off, 2e-3);
    }
    report.finish();
}

#[test]
fn occlusion_among_shapes_is_open_on_planes_and_dark_in_slots() {
    let fragment = "
        #include <geometry/sdf.wgsl>
        fn floor_sdf(p: vec3f) -> f32 { return p.y; }
        fn corner_sdf(p: vec3f) -> f32 { return min(p.y, p.x); }
        fn slot_sdf(p: vec3f) -> f32 { return max(min(p.y, 0.01 - abs(p.x)), -p.y); }
        #include <light/occlusion_sdf.wgsl> as on_floor with sdf = floor_sdf
        #include <light/occlusion_sdf.wgsl> as in_corner with sdf = corner_sdf
        #include <light/occlusion_sdf.wgsl> as in_slot with sdf = slot_sdf";
    let scope = Scope { fragment, ..Scope::default() };
    let mut report = Report::new(SECTION, "occlusion_among_shapes_is_open_on_planes_and_dark_in_slots");
    let level =
        value("on_floor_ambient_occlusion(vec3f(3.0, 0.0, 2.0), vec3f(0.0, 1.0, 0.0), 1.0, 5)", &scope)[0];
    report.near("light that reaches a lone plane", level, 1.0, 1e-6);
    let at: Vec<[f32; 1]> = (0..=40).map(|i| [i as f32 * 0.05]).collect();
    let corner = values(
        "in_corner_ambient_occlusion(vec3f(x, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0, 5)",
        &scope,
        ["x"],
        &at,
    );
    let falls = corner.windows(2).map(|pair| pair[0][0] - pair[1][0]).fold(f64::MIN, f64::max);
    report.at_most("away from a wall it grows: falls by at most", falls, 1e-6);
    report.at_most("at the foot of the wall", corner[0][0], 0.01);
    report.near("farther from the wall than the reach", corner[40][0], 1.0, 1e-6);
    let slot =
        value("in_slot_ambient_occlusion(vec3f(0.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0, 5)", &scope)[0];
    report.at_most("in a narrow slot", slot, 0.1);
    report.finish();
}

#[test]
fn occlusion_by_heights_is_that_of_craters_and_valleys() {
    let fragment = "
        fn crater(p: vec2f, footprint: f32) -> f32 { return 0.5 * length(p); }
        fn valley(p: vec2f, footprint: f32) -> f32 { return abs(p.x); }
        fn plain(p: vec2f, footprint: f32) -> f32 { return 7.0; }
        #include <light/occlusion_heightfield.wgsl> as of_crater with height = crater
        #include <light/occlusion_heightfield.wgsl> as of_valley with height = valley
        #include <light/occlusion_heightfield.wgsl> as of_plain with height = plain";
    let scope = Scope { fragment, ..Scope::default() };
    let mut report = Report::new(SECTION, "occlusion_by_heights_is_that_of_craters_and_valleys");
    let plain = value("of_plain_sky_openness(vec3f(1.0, 7.0, 2.0), 0.1, 100.0, 8, 12, 0.3)", &scope)[0];
    report.near("openness of a plain", plain, 1.0, 1e-6);
    // A horizon at elevation h all around leaves cos² h.
    let crater = value("of_crater_sky_openness(vec3f(0.0), 0.1, 100.0, 8, 12, 0.3)", &scope)[0];
    report.near("in a crater of slope .5, 1 / (1 + s²)", crater, 0.8, 1e-5);
    // Mean over all azimuths of 1 / (1 + s² cos² φ) = 1 / sqrt(1 + s²).
    let turns: Vec<[f32; 1]> = (0..64).map(|i| [i as f32 * 0.05]).collect();
    let valley = values("of_valley_sky_openness(vec3f(0.0), 0.1, 100.0, 8, 12, x)", &scope, ["x"], &turns);
    let off = valley.iter().map(|v| (v[0] - 0.5_f64.sqrt()).abs()).fold(0.0, f64::max);
    report.at_most("in a valley between slopes of 1, 8 directions: off 1 / √2", off, 2e-3);
    report.finish();
}

#[test]
fn facets_are_seen_as_their_area_says() {
    let mut random = Random::new(21);
    let mut rows: Vec<[f32; 2]> = (0..400)
        .map(|_| [random.within(-3.0, 3.0).exp2() - 0.12, random.within(-7.0, -1.5).exp2()])
        .collect();
    rows.extend([[0.0, 0.1], [0.001, 0.2], [-0.3, 0.2], [10.0, 0.05], [0.05, 0.05]]);
    let fragment = "
        #include <light/facets.wgsl>
        fn seen(tan_view: f32, deviation: f32) -> vec3f {
            return vec3f(facets_seen_area(tan_view, deviation), facets_seen_slope(tan_view, deviation));
        }";
    let scope = Scope { fragment, ..Scope::default() };
    let got = values("seen(a, s)", &scope, ["a", "s"], &rows);
    let (mut area, mut mean, mut deviation) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (row, v) in rows.iter().zip(&got) {
        let (a, s) = (f64::from(row[0]), f64::from(row[1]));
        let truth = exact::facets(a, s);
        area = area.max((v[0] - truth.area).abs() / truth.area);
        mean = mean.max((v[1] - truth.mean).abs() / s);
        deviation = deviation.max((v[2] - truth.deviation).abs() / s);
    }
    let mut report = Report::new(SECTION, "facets_are_seen_as_their_area_says");
    report.at_most("area of rough facets as seen: relative error", area, 2e-3);
    report.at_most("mean slope as seen: off, in deviations", mean, 2e-3);
    report.at_most("its deviation as seen: off, in deviations", deviation, 5e-3);
    let nasty: Vec<[f32; 2]> = [0.0, 1e-30, 1e-7, 1e4, -1e4, 1e10, -1e10_f32]
        .iter()
        .flat_map(|&a| [1e-4, 1e-3, 0.5, 10.0_f32].map(|s| [a, s]))
        .collect();
    let bad =
        values("seen(a, s)", &scope, ["a", "s"], &nasty).iter().flatten().filter(|v| !v.is_finite()).count();
    report.at_most("NaN or infinite", bad as f64, 0.0);
    report.finish();
}

#[test]
fn a_glint_gives_back_what_came() {
    // All the light that facets mirror, summed over every direction that an eye may be in.
    let fragment = "
        #include <light/facets.wgsl>
        fn mirrored(elevation: f32, deviation: f32) -> f32 {
            let to_sun = vec3f(cos(elevation), sin(elevation), 0.0);
            var sum = 0.0;
            for (var i = 0; i < 200; i++) {
                let up = (f32(i) + 0.5) * 1.5707963 / 200.0;
                var ring = 0.0;
                for (var j = 0; j < 300; j++) {
                    let phi = (f32(j) + 0.5) * 6.2831853 / 300.0;
                    let eye = vec3f(cos(up) * cos(phi), sin(up), cos(up) * sin(phi));
                    let h = normalize(to_sun + eye);
                    let area = cos(up) * facets_seen_area(tan(up), deviation);
                    ring += facets_glint(h.xz / h.y, h.y, deviation, area) * area;
                }
                sum += ring * cos(up);
            }
            return sum * (1.5707963 / 200.0) * (6.2831853 / 300.0);
        }";
    let scope = Scope { fragment, ..Scope::default() };
    let mut report = Report::new(SECTION, "a_glint_gives_back_what_came");
    for (degrees, deviation) in [(80.0_f64, 0.05), (60.0, 0.1), (45.0, 0.15), (30.0, 0.1)] {
        let elevation = degrees.to_radians();
        let got = values("mirrored(e, s)", &scope, ["e", "s"], &[[elevation as f32, deviation as f32]])[0][0];
        // What came: 1 of irradiance facing the light, on the facets' area as the sun sees it.
        let came = elevation.cos() * exact::facets(elevation.tan(), deviation).area;
        let name =
            format!("sun at {degrees}°, slopes .{:02}: mirrored over received", (deviation * 100.0) as i32);
        report.near(&name, got / came, 1.0, 0.01);
    }
    report.finish();
}
