//! A planet: places known to the centimetre at Earth's radius, ground without seams, and rays that find it.

use orogen::Preset;
use truth::planet::{EARTH, MARS, Planet, QUANTILE_68, Relief, weights};
use truth::points::Random;

use crate::harness::{Report, Scope, value, values};

const SECTION: &str = "Planets";

/// The planets with what `truth` knows of them.
const PLANETS: [(&str, Planet, &[&str]); 2] = [
    ("continents", EARTH, &["planet.scale=4194304", "planet.octaves=22"]),
    (
        "craters",
        MARS,
        &[
            "planet.relief=craters",
            "planet.scale=2097152",
            "planet.octaves=21",
            "planet.seed=4",
            "planet.peak_height=1800",
            "planet.swell=2500",
            "sky.ground_radius=3389500",
        ],
    ),
];

const FRAGMENT: &str = "#include <planet/height.wgsl>
    #include <march/globe.wgsl> as globe with above = planet_above
    fn ground_at(p: vec3f, footprint: f32) -> vec4f {
        let ground = planet_ground(p, footprint);
        return vec4f(ground.height, ground.slope);
    }
    fn march_at(origin: vec3f, direction: vec3f, far: f32) -> vec3f {
        let steps = globe_Steps(0.1, 0.001, 0.6, 140, 12, 1e-6);
        let found = globe_march(origin, normalize(direction), sky.ground_radius, planet_ceiling(), far, steps);
        return vec3f(found.distance, f32(found.hit), f32(found.steps));
    }";

fn preset(settings: &[&str]) -> Preset {
    let mut preset = Preset::of_module("planet/height.wgsl");
    for setting in settings {
        preset.set(setting).unwrap();
    }
    preset
}

fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    // NaN stays: `f64::max` would drop it.
    numbers.fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
}

#[test]
fn a_ray_out_of_steps_meets_the_ground_that_goes_on_level() {
    let mut report = Report::new(SECTION, "a_ray_out_of_steps_meets_the_ground_that_goes_on_level");
    let fragment = "#include <march/globe.wgsl> as globe with above = level_above
        fn level_above(p: vec3f, footprint: f32) -> f32 {
            return globe_height(p, 6360000.0) - 50.0;
        }
        fn march_at(dip: f32, far: f32) -> vec2f {
            let steps = globe_Steps(0.1, 0.0, 0.001, 2, 2, 1e-6);
            let direction = vec3f(cos(dip), -sin(dip), 0.0);
            let found = globe_march(vec3f(0.0, 1000.0, 0.0), direction, 6360000.0, 5000.0, far, steps);
            return vec2f(found.distance, f32(found.hit));
        }";
    let scope = Scope { fragment, ..Scope::default() };
    let (eye, ground) = (6_361_000.0_f64, 6_360_050.0);
    // The horizon lies .0173 rad below the horizontal: two rays pass above it.
    for dip in [-0.1, 0.0165, 0.0185, 0.1, 0.5] {
        let foot = eye * f64::sin(dip);
        let chord2 = ground * ground - (eye * f64::cos(dip)).powi(2);
        let meets = (dip > 0.0 && chord2 > 0.0).then(|| foot - chord2.sqrt());
        let found =
            values("march_at(dip, far)", &scope, ["dip", "far"], &[[dip as f32, 1e6], [dip as f32, 500.0]]);
        let (distance, hit) = (found[0][0], f64::from(u8::from(meets.is_some())));
        report.at_most(&format!("dip {dip}: met or not, errors"), (found[0][1] - hit).abs(), 0.0);
        let error = (distance - meets.unwrap_or(1e6)).abs() / distance;
        report.at_most(&format!("dip {dip}: error of the distance, as a part"), error, 2e-3);
        report.at_most(&format!("dip {dip}: met beyond how far is looked"), found[1][1], 0.0);
    }
    report.finish();
}

#[test]
fn places_are_moved_and_scaled_without_losing_digits() {
    let mut report = Report::new(SECTION, "places_are_moved_and_scaled_without_losing_digits");
    let scope = Scope { includes: &["<math/precise.wgsl>"], ..Scope::default() };
    let mut random = Random::new(91);
    let points: Vec<[f32; 6]> = (0..50_000)
        .map(|_| {
            let cell = random.within(-8e6, 8e6).floor();
            let move_by = [3.0, 1e3, 1e5][random.bits() as usize % 3];
            [
                cell,
                random.within(0.0, 0.999_999),
                random.within(-move_by, move_by),
                (random.bits() % 24) as f32,
                0.0,
                0.0,
            ]
        })
        .collect();
    let columns = ["i:i32", "f", "m", "n:u32", "a", "b"];
    let place = "Precise(vec3i(i, -i, 0), vec3f(f, f, f))";
    let read = |call: &str| {
        let rows = values(&format!("({call}).cell"), &scope, columns, &points);
        let fractions = values(&format!("({call}).fraction"), &scope, columns, &points);
        rows.into_iter().zip(fractions).collect::<Vec<_>>()
    };
    let within = |rows: &[(Vec<f64>, Vec<f64>)]| {
        let outside = |row: &&(Vec<f64>, Vec<f64>)| row.1.iter().any(|f| !(0.0..1.0).contains(f));
        rows.iter().filter(outside).count() as f64
    };
    let moved = read(&format!("precise_moved({place}, vec3f(m, m, m))"));
    let error = largest(points.iter().zip(&moved).map(|(p, (cell, fraction))| {
        let [i, f, m] = [0, 1, 2].map(|axis| f64::from(p[axis]));
        (cell[0] - i + fraction[0] - f - m).abs().max((cell[1] + i + fraction[1] - f - m).abs())
    }));
    report.at_most("`precise_moved`, up to 1e5 from cells up to ±8e6: error, in cells", error, 2e-7);
    report.at_most("`precise_moved`: fractions outside of 0 .. 1", within(&moved), 0.0);
    let coarser = read(&format!("precise_coarser({place}, n)"));
    let error = largest(points.iter().zip(&coarser).map(|(p, (cell, fraction))| {
        let [i, f, n] = [0, 1, 3].map(|axis| f64::from(p[axis]));
        let size = n.exp2();
        let worst = |cell: f64, fraction: f64, at: f64| (cell * size + fraction * size - at).abs() / size;
        worst(cell[0], fraction[0], i + f).max(worst(cell[1], fraction[1], f - i))
    }));
    report.at_most("`precise_coarser`, up to 2²³ cells in one: error, in the large cells", error, 1.3e-7);
    report.at_most("`precise_coarser`: fractions outside of 0 .. 1", within(&coarser), 0.0);
    let finer = read(&format!("precise_finer({place}, n & 7)"));
    let error = largest(points.iter().zip(&finer).map(|(p, (cell, fraction))| {
        let [i, f] = [0, 1].map(|axis| f64::from(p[axis]));
        let size = f64::from(p[3] as u32 & 7).exp2();
        (cell[0] - i * size + fraction[0] - f * size).abs()
    }));
    report.at_most("`precise_finer`: error, in the small cells", error, 0.0);
    report.finish();
}

#[test]
fn a_globe_is_known_to_the_millimetre_near_its_top() {
    let mut report = Report::new(SECTION, "a_globe_is_known_to_the_millimetre_near_its_top");
    let scope = Scope { includes: &["<geometry/globe.wgsl>"], ..Scope::default() };
    let radius = 6_360_000.0_f64;
    let mut random = Random::new(92);
    for (name, reach, bound) in [("1 km", 1e3, 2e-4), ("100 km", 1e5, 0.03), ("10,000 km", 1e7, 3.0)] {
        let points: Vec<[f32; 3]> = random.points(20_000, reach);
        let found = values("globe_height(p, 6360000.0)", &scope, ["x", "y", "z"], &points);
        let error = largest(points.iter().zip(&found).map(|(p, found)| {
            let [x, y, z] = p.map(f64::from);
            // |p - c| - R, multiplied out so that f64 keeps its digits as well.
            let out = (x * x + (y + radius).powi(2) + z * z).sqrt();
            (found[0] - (x * x + y * y + z * z + 2.0 * radius * y) / (out + radius)).abs()
        }));
        report.at_most(&format!("`globe_height` within {name} of the top: error (m)"), error, bound);
    }
    // Rays from 2 m to 20,000 km up, down to the sphere at sea level.
    let rays: Vec<[f32; 6]> = (0..20_000)
        .map(|_| {
            let up = 10_f32.powf(random.within(0.3, 7.3));
            let azimuth = random.within(0.0, std::f32::consts::TAU);
            let dip = -10_f32.powf(random.within(-2.5, 0.19));
            let (s, c) = dip.sin_cos();
            [
                random.within(-50.0, 50.0),
                up,
                random.within(-50.0, 50.0),
                c * azimuth.sin(),
                s,
                c * azimuth.cos(),
            ]
        })
        .collect();
    let found = values(
        "globe_span(p, normalize(vec3f(dx, dy, dz)), 6360000.0, 0.0)",
        &scope,
        ["x", "y", "z", "dx", "dy", "dz"],
        &rays,
    );
    let mut errors = Vec::new();
    let mut wrong = 0.0;
    for (ray, found) in rays.iter().zip(&found) {
        let [x, y, z, dx, dy, dz] = ray.map(f64::from);
        let length = (dx * dx + dy * dy + dz * dz).sqrt();
        let [dx, dy, dz] = [dx / length, dy / length, dz / length];
        let b = x * dx + (y + radius) * dy + z * dz;
        let c = x * x + z * z + y * (y + 2.0 * radius);
        let inside = b * b - c;
        if inside.abs() < 2e-3 * c.max(b * b) {
            continue; // grazes: f32 directions cannot tell
        }
        if (inside < 0.0) != (found[0] > found[1]) {
            wrong += 1.0;
        } else if inside > 0.0 {
            let near = c / (inside.sqrt() - b);
            errors.push((found[0] - near).abs() / near);
        }
    }
    errors.sort_by(f64::total_cmp);
    report.at_most("`globe_span`: rays that hit for a miss, or miss for a hit", wrong, 0.0);
    report.told("`globe_span`: rays compared", errors.len() as f64);
    report.at_most(
        "`globe_span`: largest error of the distance, as a part of it",
        errors[errors.len() - 1],
        1e-5,
    );
    report.at_most(
        "`globe_span`: 95 % of the errors, as a part of the distance",
        errors[errors.len() * 95 / 100],
        1e-6,
    );
    report.finish();
}

#[test]
fn three_planes_blend_without_seams() {
    let mut report = Report::new(SECTION, "three_planes_blend_without_seams");
    let scope = Scope { includes: &["<geometry/triplanar.wgsl>"], ..Scope::default() };
    let mut random = Random::new(93);
    let mut directions: Vec<[f32; 3]> = Vec::new();
    while directions.len() < 20_000 {
        let p = random.point::<3>(1.0);
        let length = p.iter().map(|x| x * x).sum::<f32>().sqrt();
        if (0.1..1.0).contains(&length) {
            directions.push(p.map(|x| x / length));
        }
    }
    for sharpness in [2.0, 6.0, 16.0] {
        let call = |part: &str| format!("triplanar_weights(p, {sharpness:?}).{part}");
        let found = values(&call("weights"), &scope, ["x", "y", "z"], &directions);
        let error = largest(directions.iter().zip(&found).map(|(p, found)| {
            let truth = weights(p.map(f64::from), sharpness);
            largest((0..3).map(|i| (found[i] - truth[i]).abs()))
        }));
        report.at_most(&format!("weights, sharpness {sharpness}: error"), error, 2e-6);
        let slopes: Vec<_> = (0..3)
            .map(|i| values(&call(&format!("gradients[{i}]")), &scope, ["x", "y", "z"], &directions))
            .collect();
        let error = largest(directions.iter().enumerate().map(|(index, p)| {
            let p = p.map(f64::from);
            let normal = |axis: usize, by: f64| {
                let mut q = p;
                q[axis] += by;
                weights(q, sharpness)
            };
            largest((0..9).map(|k| {
                let (i, axis) = (k / 3, k % 3);
                let difference = (normal(axis, 1e-6)[i] - normal(axis, -1e-6)[i]) / 2e-6;
                (slopes[i][index][axis] - difference).abs()
            }))
        }));
        report.at_most(
            &format!("weights' gradients, sharpness {sharpness}: error (1 / radius)"),
            error,
            2e-3,
        );
    }
    report.finish();
}

/// A preset of `planet` whose origin lies at `latitude` and `longitude`, and its truth: where the GPU puts the origin is known
/// to half a metre only, and taken from there.
fn turned(planet: &Planet, settings: &[&str], latitude: f64, longitude: f64) -> (Preset, Planet) {
    let mut preset = preset(settings);
    preset.set(&format!("planet.latitude={latitude}")).unwrap();
    preset.set(&format!("planet.longitude={longitude}")).unwrap();
    let scope = Scope { fragment: FRAGMENT, preset: Some(&preset), ..Scope::default() };
    let column = |i: usize| value(&format!("planet_axes()[{i}]"), &scope);
    let origin = "planet_place(vec3f(0.0), planet_grain())";
    let cell = value(&format!("{origin}.cell"), &scope);
    let fraction = value(&format!("{origin}.fraction"), &scope);
    let grain = planet.scale / f64::from(1_u32 << planet.octaves);
    let axes = std::array::from_fn(|i| column(i).try_into().unwrap());
    let origin = std::array::from_fn(|axis| (cell[axis] + fraction[axis]) * grain);
    let mut relief = planet.relief;
    if let Relief::Continents(quantile, ..) = &mut relief {
        // Good to 4.5e-4 only, which shifts the sea level by a metre: a row of its own.
        *quantile = value("normal_quantile(0.68)", &scope)[0];
    }
    (preset, Planet { axes, origin, relief, ..*planet })
}

/// Pairs of places to both sides of the border between octants that runs through the origin, `reach` (m) along it: the
/// planet's axis `axis` is level with them, the world's `across` (0 or 2) crosses it. The origin itself is some centimetres
/// beside it, as far as f32 knows degrees.
fn beside_border(
    preset: &Preset,
    [axis, across]: [usize; 2],
    [aside, reach]: [f64; 2],
    random: &mut Random,
) -> Vec<[f32; 3]> {
    let scope = Scope { fragment: FRAGMENT, preset: Some(preset), ..Scope::default() };
    let row: [f64; 3] = std::array::from_fn(|i| value(&format!("planet_axes()[{i}]"), &scope)[axis]);
    let radius = value("sky.ground_radius", &scope)[0];
    let places = (0..400).flat_map(|_| {
        let along = f64::from(random.within(-reach as f32, reach as f32));
        let border = -(row[1] * radius + row[2 - across] * along) / row[across];
        [-aside, aside].map(|off| {
            let mut place = [along as f32, 0.0, along as f32];
            place[across] = (border + off) as f32;
            place
        })
    });
    places.collect()
}

#[test]
fn a_planet_s_ground_has_no_seam_between_its_octants() {
    let mut report = Report::new(SECTION, "a_planet_s_ground_has_no_seam_between_its_octants");
    let mut random = Random::new(94);
    for (name, planet, settings) in PLANETS {
        // Origins on the borders: the equator, and meridians of 0 and 90 degrees. What changes over the 20 µm from one
        // side to the other is a seam; between places as far apart beside the border it is what crests a metre wide bend.
        let (mut step, mut seam, mut inside) = (0.0_f64, 0.0_f64, 0.0_f64);
        let (mut pairs_seen, mut crossed) = (0.0, 0.0);
        let borders = [
            (0.0, 33.0, [1, 2]),
            (41.0, 0.0, [2, 0]),
            (-27.0, 90.0, [0, 0]),
            (0.0, 0.0, [1, 2]),
            (0.0, 0.0, [2, 0]),
        ];
        for (latitude, longitude, [axis, across]) in borders {
            let (preset, _) = turned(&planet, settings, latitude, longitude);
            let scope = Scope { fragment: FRAGMENT, preset: Some(&preset), ..Scope::default() };
            for reach in [3_000.0, 300_000.0] {
                let pairs = beside_border(&preset, [axis, across], [1e-5, reach], &mut random);
                let mut off_border = pairs.clone();
                for place in &mut off_border {
                    place[across] += 3.0;
                }
                let read = |places: &[[f32; 3]], call: &str| values(call, &scope, ["x", "y", "z"], places);
                let sides = read(&pairs, &format!("(planet_axes() * planet_up(p))[{axis}]"));
                let found = read(&pairs, "ground_at(p, 0.0)");
                let beside = read(&off_border, "ground_at(p, 0.0)");
                let jump = |pair: &[Vec<f64>]| largest((1..4).map(|i| (pair[0][i] - pair[1][i]).abs()));
                for pair in found.chunks(2) {
                    step = step.max((pair[1][0] - pair[0][0]).abs());
                    seam = seam.max(jump(pair));
                    pairs_seen += 1.0;
                }
                inside = beside.chunks(2).map(jump).fold(inside, f64::max);
                crossed += sides.chunks(2).filter(|pair| pair[0][0] * pair[1][0] < 0.0).count() as f64;
            }
        }
        report.near(
            &format!("{name}: pairs 20 µm apart with a border between them, of 4,000"),
            crossed,
            pairs_seen,
            0.0,
        );
        // f32 sums forms kilometres high to a centimetre or two.
        report.at_most(&format!("{name}: height from one side of a border to the other (m)"), step, 0.03);
        report.at_most(&format!("{name}: slope from side to side, every octave"), seam, 1e-3);
        report.told(&format!("{name}: the same 3 m beside the border"), inside);
    }
    report.finish();
}

#[test]
fn a_planet_s_slope_is_that_of_its_height() {
    let mut report = Report::new(SECTION, "a_planet_s_slope_is_that_of_its_height");
    let mut random = Random::new(95);
    for (name, planet, settings) in PLANETS {
        let (mut heights, mut slopes, mut steepness) = (Vec::new(), Vec::new(), Vec::new());
        for origin in 0..3 {
            let latitude = f64::from(random.within(-85.0, 85.0).round());
            let longitude = f64::from(random.within(-180.0, 180.0).round());
            let (preset, truth) = turned(&planet, settings, latitude, longitude);
            let scope = Scope { fragment: FRAGMENT, preset: Some(&preset), ..Scope::default() };
            let reach = if origin % 2 == 0 { 5_000.0 } else { 100_000.0 };
            // Octaves of 16 m and more: differences over centimetres tell their slope.
            let points: Vec<[f32; 3]> = (0..300)
                .map(|_| {
                    [random.within(-reach, reach), random.within(0.0, 500.0), random.within(-reach, reach)]
                })
                .collect();
            let found = values("ground_at(p, 8.0)", &scope, ["x", "y", "z"], &points);
            for (p, found) in points.iter().zip(&found) {
                let slope = &found[1..];
                let p = p.map(f64::from);
                let at =
                    |offset: [f64; 3]| truth.height(std::array::from_fn(|axis| p[axis] + offset[axis]), 4.0);
                heights.push((found[0] - at([0.0; 3])).abs());
                let h = 0.02;
                let outward = (planet.radius + p[1]) / planet.radius;
                let difference = |axis: usize| {
                    let mut step = [0.0; 3];
                    step[axis] = h;
                    let ahead = at(step);
                    step[axis] = -h;
                    (ahead - at(step)) / (2.0 * h) * outward
                };
                let error = largest((0..3).map(|axis| (slope[axis] - difference(axis)).abs()));
                slopes.push(error);
                steepness.push(slope.iter().map(|x| x * x).sum::<f64>().sqrt());
            }
        }
        heights.sort_by(f64::total_cmp);
        slopes.sort_by(f64::total_cmp);
        let mean = steepness.iter().sum::<f64>() / steepness.len() as f64;
        report.told(&format!("{name}: mean slope"), mean);
        report.at_most(
            &format!("{name}: height against f64, 99 % of places (m)"),
            heights[heights.len() * 99 / 100],
            0.02,
        );
        report.at_most(
            &format!("{name}: slope against f64 differences, 99 % of places"),
            slopes[slopes.len() * 99 / 100],
            1e-3,
        );
    }
    report.finish();
}

#[test]
fn detail_a_metre_wide_is_smooth_at_earth_s_radius() {
    let mut report = Report::new(SECTION, "detail_a_metre_wide_is_smooth_at_earth_s_radius");
    // The finest octave is a metre wide; lines of 1,024 places 1/16 m apart.
    let mut settings = PLANETS[0].2.to_vec();
    settings.extend(["planet.gain=0.7", "planet.hills=1"]);
    let planet = Planet { gain: 0.7, relief: Relief::Continents(QUANTILE_68, 3800.0, 0.16, 1.0), ..EARTH };
    let step = 0.0625_f32;
    let mut lines = 0.0;
    let (mut own, mut true_own, mut noise) = (0.0, 0.0, 0.0);
    for (latitude, longitude) in [(20.0, 0.0), (55.0, -120.0)] {
        let (preset, truth) = turned(&planet, &settings, latitude, longitude);
        let scope = Scope { fragment: FRAGMENT, preset: Some(&preset), ..Scope::default() };
        let points: Vec<[f32; 3]> = (0..1024).map(|i| [i as f32 * step, 0.0, 7.0]).collect();
        // The slope to the east: what light shows, and not rounded to the height's own size.
        let found: Vec<f64> = values("planet_ground(p, 0.0).slope.x", &scope, ["x", "y", "z"], &points)
            .iter()
            .map(|row| row[0])
            .collect();
        let expected: Vec<f64> = points
            .iter()
            .map(|p| {
                let at = |by: f64| truth.height([f64::from(p[0]) + by, 0.0, f64::from(p[2])], 0.0);
                (at(1e-3) - at(-1e-3)) / 2e-3
            })
            .collect();
        let rough = |line: &[f64]| {
            line.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).powi(2)).sum::<f64>() / (line.len() - 2) as f64
        };
        own += rough(&found);
        true_own += rough(&expected);
        let error: Vec<f64> = found.iter().zip(&expected).map(|(a, b)| a - b).collect();
        noise += rough(&error);
        lines += 1.0;
    }
    let ratio = (own / true_own).sqrt();
    report.told("lines of 64 m in steps of 1/16 m", lines);
    report.told("rms second difference of the slope, f64", (true_own / lines).sqrt());
    report.near("rms second difference of the slope over that in f64", ratio, 1.0, 0.01);
    report.at_most("what is no ground of it, over the whole", (noise / true_own).sqrt(), 0.05);

    // The noise itself: as rough a metre wide 6,371 km away as beside the origin.
    let scope = Scope { includes: &["<noise/perlin.wgsl>"], ..Scope::default() };
    let mut random = Random::new(97);
    let points: Vec<[f32; 2]> =
        (0..20_000).map(|_| [random.within(0.1, 0.9), random.within(0.0, 1.0)]).collect();
    let second = |call: &str| {
        let at = |x: &str| call.replace("$x", x);
        let sum = format!("{} - 2.0 * {} + {}", at("x - 0.0625"), at("x"), at("x + 0.0625"));
        let rows = values(&sum, &scope, ["x", "y"], &points);
        (rows.iter().map(|row| row[0] * row[0]).sum::<f64>() / rows.len() as f64).sqrt()
    };
    let cells = |i: &str| format!("perlin_noise2_at_grad(vec2i({i}, i32(y * 4096.0)), vec2f($x, 0.4), 7u).x");
    let near = second(&cells("i32(x * 1e4) & 1023"));
    let far = second(&cells("6371000 + (i32(x * 1e4) & 1023)"));
    report.near(
        "second difference of a noise 1 m wide, 6,371 km away over beside the origin",
        far / near,
        1.0,
        0.03,
    );
    report.finish();
}

#[test]
fn rays_meet_a_planet_s_ground_where_it_is() {
    let mut report = Report::new(SECTION, "rays_meet_a_planet_s_ground_where_it_is");
    let mut random = Random::new(98);
    for (name, planet, settings) in PLANETS {
        let (preset, truth) = turned(&planet, settings, 29.5, 2.0);
        let scope = Scope { fragment: FRAGMENT, preset: Some(&preset), ..Scope::default() };
        // From a walker's eye rays graze crest after crest: the march leaves out some, and says so.
        for (from, up, steepest, shallowest, far, shortest, missable, part, bound) in [
            ("2 m above the ground", 2.0, -0.6, -0.005, 20_000.0, 0.1, 4.0, 50, 0.01),
            ("10 km", 10_000.0, -1.2, -0.08, 200_000.0, 5.0, 1.0, 90, 1e-4),
            ("400 km", 400_000.0, -1.5, -0.4, 3_000_000.0, 50.0, 1.0, 90, 1e-4),
        ] {
            let ground = truth.height([0.0; 3], 0.0);
            let rays: Vec<[f32; 6]> = (0..60)
                .map(|_| {
                    let azimuth = random.within(0.0, std::f32::consts::TAU);
                    let (s, c) = random.within(steepest, shallowest).sin_cos();
                    [0.0, (ground + up) as f32, 0.0, c * azimuth.sin(), s, -c * azimuth.cos()]
                })
                .collect();
            let columns = ["x", "y", "z", "dx", "dy", "dz"];
            let found = values(&format!("march_at(p, vec3f(dx, dy, dz), {far:?})"), &scope, columns, &rays);
            let (mut missed, mut phantom, mut errors) = (0.0, 0.0, Vec::new());
            for (index, ray) in rays.iter().enumerate() {
                let [x, y, z, dx, dy, dz] = ray.map(f64::from);
                let length = (dx * dx + dy * dy + dz * dz).sqrt();
                let expected =
                    truth.first_crossing([x, y, z], [dx / length, dy / length, dz / length], far, shortest);
                match (expected, found[index][1] != 0.0) {
                    (Some(at), true) => errors.push((found[index][0] - at).abs() / at.max(1.0)),
                    (Some(_), false) => missed += 1.0,
                    (None, true) => phantom += 1.0,
                    (None, false) => {}
                }
            }
            errors.sort_by(f64::total_cmp);
            let what = format!("{name}, from {from}");
            report.told(&format!("{what}: rays of 60 that meet the ground"), errors.len() as f64);
            report.at_most(
                &format!("{what}: crossings missed, or found where there are none"),
                missed + phantom,
                missable,
            );
            report.at_most(
                &format!("{what}: {part} % of the errors, as a part of the distance"),
                errors[errors.len() * part / 100],
                bound,
            );
            report.told(&format!("{what}: most steps"), largest(found.iter().map(|row| row[2])));
        }
    }
    report.finish();
}

#[test]
fn planets_are_as_wet_and_as_high_as_they_say() {
    let mut report = Report::new(SECTION, "planets_are_as_wet_and_as_high_as_they_say");
    let mut random = Random::new(99);
    // All over the globe: the place beneath a point far out, whatever its height.
    let points: Vec<[f32; 3]> = (0..4000)
        .map(|_| {
            let up: f32 = random.within(-1.0, 1.0);
            let azimuth = random.within(0.0, std::f32::consts::TAU);
            let level = (1.0 - up * up).sqrt();
            [6.36e6 * level * azimuth.cos(), 6.36e6 * (up - 1.0), 6.36e6 * level * azimuth.sin()]
        })
        .collect();
    let fragment = Scope { fragment: FRAGMENT, ..Scope::default() };
    let quantile = value("normal_quantile(0.68)", &fragment)[0];
    report.near("`normal_quantile(0.68)`", quantile, QUANTILE_68, 4.5e-4);
    for ocean in [0.68] {
        let mut shares = Vec::new();
        let mut highest = -1e9_f64;
        let mut ceiling = 0.0;
        for seed in 1..=6 {
            let mut preset = preset(PLANETS[0].2);
            preset.set(&format!("planet.seed={}", 100 * seed)).unwrap();
            preset.set(&format!("planet.ocean={ocean}")).unwrap();
            let scope = Scope { fragment: FRAGMENT, preset: Some(&preset), ..Scope::default() };
            let heights = values("planet_ground(p, 10000.0).height", &scope, ["x", "y", "z"], &points);
            shares.push(heights.iter().filter(|row| row[0] < 0.0).count() as f64 / heights.len() as f64);
            highest = heights.iter().map(|row| row[0]).fold(highest, f64::max);
            ceiling = value("planet_ceiling()", &scope)[0];
        }
        let mean = shares.iter().sum::<f64>() / shares.len() as f64;
        report.near(&format!("sea, share of six planets for `planet.ocean` {ocean}"), mean, ocean, 0.08);
        report.told("driest of them", shares.iter().copied().fold(1.0, f64::min));
        report.told("wettest of them", shares.iter().copied().fold(0.0, f64::max));
        report.at_most("highest ground over the ceiling", highest / ceiling, 1.0);
    }
    report.finish();
}

#[test]
fn a_planet_is_seen_from_everywhere_without_nan() {
    let mut report = Report::new(SECTION, "a_planet_is_seen_from_everywhere_without_nan");
    let settings: [(&str, &[&str]); 2] = [
        ("continents", &["sky.model=atmosphere", "quality=low"]),
        (
            "craters",
            &[
                "sky.model=atmosphere",
                "quality=low",
                "planet.relief=craters",
                "planet.cover=dust",
                "planet.water=false",
                "planet.clouds=false",
            ],
        ),
    ];
    for (name, settings) in settings {
        let mut preset = Preset::of_module("scene/planet.wgsl");
        for setting in settings {
            preset.set(setting).unwrap();
        }
        let radius = 6_360_000.0;
        let mut random = Random::new(101);
        let mut rays: Vec<[f32; 6]> = Vec::new();
        let toward_sun = [-0.5455, 0.309, 0.779]; // the default sun's direction, near enough to look into it
        for origin in [
            [0.0, 2.0, 0.0],
            [0.0, 0.0, 0.0],
            [300.0, 9_000.0, -200.0],
            [0.0, -12_000.0, 0.0],
            [0.0, 100_000.0, 0.0],
            [0.0, 1e7, 0.0],
            [2e7, -radius, 0.0],
            [0.0, -radius, 0.0],
            [1e6, -radius, -2e6],
            [0.0, -2.0 * radius, 0.0],
            [0.0, -2.0 * radius - 5.0, 0.0],
            [0.0, 1e9, 0.0],
        ] {
            for direction in [
                [0.0, 1.0, 0.0],
                [0.0, -1.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 0.0, -1.0],
                toward_sun,
                toward_sun.map(|x| -x),
            ] {
                rays.push([origin[0], origin[1], origin[2], direction[0], direction[1], direction[2]]);
            }
            for _ in 0..30 {
                let d = random.point::<3>(1.0);
                rays.push([origin[0], origin[1], origin[2], d[0], d[1], d[2] + 1e-3]);
            }
        }
        let scope = Scope { includes: &["<scene/planet.wgsl>"], preset: Some(&preset), ..Scope::default() };
        let columns = ["x", "y", "z", "dx", "dy", "dz"];
        let seen = values("scene_trace(p, normalize(vec3f(dx, dy, dz))).radiance", &scope, columns, &rays);
        let odd = seen.iter().filter(|row| row.iter().any(|x| !x.is_finite() || *x < 0.0)).count();
        report.told(&format!("{name}: rays"), rays.len() as f64);
        report.at_most(&format!("{name}: rays that see NaN, infinity or less than nothing"), odd as f64, 0.0);
    }
    report.finish();
}
