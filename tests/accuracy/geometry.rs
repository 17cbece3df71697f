//! Rays, signed distances, normals, repetition.

use truth::geometry as exact;
use truth::geometry::{Vec3, along, distance, dot, length, unit, wide};
use truth::points::Random;

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Geometry";

const RAY: &[&str] = &["<geometry/ray.wgsl>"];

/// Unit directions, to the last bit of an `f32`.
fn direction(random: &mut Random) -> [f32; 3] {
    loop {
        let p: [f32; 3] = random.point(1.0);
        let size = length(wide(p));
        if (0.1..1.0).contains(&size) {
            return p.map(|x| (f64::from(x) / size) as f32);
        }
    }
}

fn triple(row: &[f32]) -> [f32; 3] {
    [row[0], row[1], row[2]]
}

#[test]
fn rays_meet_spheres_where_the_closed_form_says() {
    let mut random = Random::new(1);
    let rows: Vec<[f32; 10]> = (0..100_000)
        .map(|i| {
            let o: [f32; 3] = random.point(if i % 3 == 0 { 1000.0 } else { 10.0 });
            let mut d = direction(&mut random);
            let c: [f32; 3] = random.point(10.0);
            let mut r = random.within(0.0, 8.0);
            match i % 10 {
                // Aimed at the centre; touching; starting in the centre; along an axis; a point.
                0 => d = unit(along(wide(c), -1.0, wide(o))).map(|x| x as f32),
                1 => {
                    let oc = along(wide(c), -1.0, wide(o));
                    r = length(along(oc, -dot(oc, wide(d)), wide(d))) as f32;
                }
                2 => return [c[0], c[1], c[2], d[0], d[1], d[2], c[0], c[1], c[2], r],
                3 => d = [0.0, 0.0, -1.0],
                4 => r = 0.0,
                _ => {}
            }
            [o[0], o[1], o[2], d[0], d[1], d[2], c[0], c[1], c[2], r]
        })
        .collect();
    let got = values(
        "ray_sphere(vec3f(ox, oy, oz), vec3f(dx, dy, dz), vec3f(cx, cy, cz), r)",
        &Scope { includes: RAY, ..Scope::default() },
        ["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"],
        &rows,
    );
    let (mut off, mut wrong, mut hits) = (0.0_f64, 0.0_f64, 0);
    for (row, span) in rows.iter().zip(&got) {
        let (o, d, c) = (wide(triple(row)), wide(triple(&row[3..])), wide(triple(&row[6..])));
        let r = f64::from(row[9]);
        let size = distance(o, c) + r;
        let truth = exact::ray_sphere(o, d, c, r);
        if span[0] <= span[1] {
            hits += 1;
            for t in [span[0], span[1]] {
                off = off.max((distance(along(o, t, d), c) - r).abs() / size);
            }
        }
        if truth.is_some() != (span[0] <= span[1]) {
            let oc = along(c, -1.0, o);
            let aside = length(along(oc, -dot(oc, d) / dot(d, d), d));
            wrong = wrong.max((aside - r).abs() / size);
        }
    }
    let mut report = Report::new(SECTION, "rays_meet_spheres_where_the_closed_form_says");
    report.told("ray and sphere: rays of 100,000 that meet", f64::from(hits));
    report.at_most("entry and exit off the sphere, over the scene's size", off, 1e-6);
    report.at_most(
        "where hit or miss differs from f64: how near the ray passes the edge, over size",
        wrong,
        1e-6,
    );
    report.finish();
}

#[test]
fn rays_meet_boxes_where_the_closed_form_says() {
    let mut random = Random::new(2);
    let rows: Vec<[f32; 12]> = (0..100_000)
        .map(|i| {
            let mut o: [f32; 3] = random.point(if i % 3 == 0 { 1000.0 } else { 10.0 });
            let mut d = direction(&mut random);
            let (a, b): ([f32; 3], [f32; 3]) = (random.point(10.0), random.point(10.0));
            let low: [f32; 3] = std::array::from_fn(|i| a[i].min(b[i]));
            let high: [f32; 3] = std::array::from_fn(|i| a[i].max(b[i]));
            match i % 10 {
                // Parallel to two faces, to four; in the plane of a face; on an edge; from inside.
                0 => d = unit([f64::from(d[0]), 0.0, f64::from(d[2])]).map(|x| x as f32),
                1 => d = [0.0, -1.0, 0.0],
                2 => (o[1], d) = (high[1], [1.0, 0.0, 0.0]),
                3 => (o, d) = ([low[0], low[1], o[2]], [0.0, 0.0, 1.0]),
                4 => o = std::array::from_fn(|i| 0.5 * (low[i] + high[i])),
                _ => {}
            }
            [o[0], o[1], o[2], d[0], d[1], d[2], low[0], low[1], low[2], high[0], high[1], high[2]]
        })
        .collect();
    let got = values(
        "ray_box(vec3f(ox, oy, oz), vec3f(dx, dy, dz), vec3f(ax, ay, az), vec3f(bx, by, bz))",
        &Scope { includes: RAY, ..Scope::default() },
        ["ox", "oy", "oz", "dx", "dy", "dz", "ax", "ay", "az", "bx", "by", "bz"],
        &rows,
    );
    let (mut off, mut wrong, mut hits) = (0.0_f64, 0.0_f64, 0);
    for (row, span) in rows.iter().zip(&got) {
        let (o, d) = (wide(triple(row)), wide(triple(&row[3..])));
        let (low, high) = (wide(triple(&row[6..])), wide(triple(&row[9..])));
        let middle: Vec3 = std::array::from_fn(|i| f64::midpoint(low[i], high[i]));
        let half: Vec3 = std::array::from_fn(|i| 0.5 * (high[i] - low[i]));
        let size = distance(o, middle) + length(half);
        let from_faces = |t: f64| exact::to_box(along(along(o, t, d), -1.0, middle), half).abs() / size;
        let truth = exact::ray_box(o, d, low, high);
        if span[0] <= span[1] {
            hits += 1;
            off = off.max(from_faces(span[0])).max(from_faces(span[1]));
        }
        // Hit or miss may differ only where the ray but touches: the chord, or the gap, is as good as none.
        match (truth, span[0] <= span[1]) {
            (Some((near, far)), false) => wrong = wrong.max((far - near) / size),
            (None, true) => wrong = wrong.max((span[1] - span[0]) / size),
            _ => {}
        }
    }
    let mut report = Report::new(SECTION, "rays_meet_boxes_where_the_closed_form_says");
    report.told("ray and box: rays of 100,000 that meet", f64::from(hits));
    report.at_most("entry and exit off the faces, over the scene's size", off, 1e-6);
    report.at_most("where hit or miss differs from f64: the chord, over size", wrong, 2e-6);
    report.finish();
}

#[test]
fn spans_follow_their_convention() {
    // Every row: expression, near, far; f32 holds all of these exactly.
    const FAR: f64 = 1.000_000_015_047_466_2e30;
    let cases: [(&str, f64, f64); 16] = [
        ("ray_sphere(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(5.0, 0.0, 0.0), 2.0)", 3.0, 7.0),
        ("ray_sphere(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0), 2.0)", -2.0, 2.0),
        ("ray_sphere(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(-5.0, 0.0, 0.0), 2.0)", -7.0, -3.0),
        ("ray_sphere(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(5.0, 2.0, 0.0), 2.0)", 5.0, 5.0),
        ("ray_sphere(vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(5.0, 3.0, 0.0), 2.0)", FAR, -FAR),
        ("ray_plane(vec3f(0.0, 3.0, 0.0), vec3f(0.0, -1.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0)", 2.0, 2.0),
        ("ray_plane(vec3f(0.0, 3.0, 0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0)", FAR, -FAR),
        ("ray_plane(vec3f(0.0, 1.0, 0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0)", -FAR, FAR),
        ("ray_half_space(vec3f(0.0, 3.0, 0.0), vec3f(0.0, -1.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0)", 2.0, FAR),
        ("ray_half_space(vec3f(0.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0)", -FAR, 1.0),
        ("ray_half_space(vec3f(0.0, 3.0, 0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), 1.0)", FAR, -FAR),
        ("ray_slab(0.0, -0.5, -3.0, -1.0)", 2.0, 6.0),
        ("ray_slab(-1.0, 0.0, -3.0, -1.0)", -FAR, FAR),
        ("ray_slab(0.0, 0.0, -3.0, -1.0)", FAR, -FAR),
        ("ray_box(vec3f(0.0, 1.0, -4.0), vec3f(0.0, 0.0, 1.0), vec3f(-1.0), vec3f(1.0))", 3.0, 5.0),
        ("ray_box(vec3f(0.0, 1.1, -4.0), vec3f(0.0, 0.0, 1.0), vec3f(-1.0), vec3f(1.0))", FAR, -FAR),
    ];
    let scope = Scope { includes: RAY, ..Scope::default() };
    let mut off: f64 = 0.0;
    for (expression, near, far) in cases {
        let got = crate::harness::value(expression, &scope);
        assert!(!got[0].is_nan() && !got[1].is_nan(), "{expression}");
        off = off
            .max((got[0] - near).abs() / near.abs().max(1.0))
            .max((got[1] - far).abs() / far.abs().max(1.0));
    }
    let mut report = Report::new(SECTION, "spans_follow_their_convention");
    report.at_most("near and far of 16 cases worked by hand (misses, insides, parallels, touches)", off, 0.0);
    report.finish();
}

#[test]
fn rays_stay_finite_for_every_finite_input() {
    let nasty =
        [0.0, -0.0, 1e-40, 1e-30, -1e-20, 1e-7, 0.5, 1.0, -1.0, 1e7, -1e19, 1e20, 3e38, -3e38, f32::MAX];
    let mut random = Random::new(3);
    let rows: Vec<[f32; 10]> =
        (0..50_000).map(|_| std::array::from_fn(|_| nasty[random.bits() as usize % nasty.len()])).collect();
    let columns = ["ox", "oy", "oz", "dx", "dy", "dz", "cx", "cy", "cz", "r"];
    let scope = Scope { includes: RAY, ..Scope::default() };
    let (mut bad, mut largest) = (0, 0.0_f64);
    for expression in [
        "ray_sphere(vec3f(ox, oy, oz), vec3f(dx, dy, dz), vec3f(cx, cy, cz), abs(r))",
        "ray_box(vec3f(ox, oy, oz), vec3f(dx, dy, dz), min(vec3f(cx, cy, cz), vec3f(r)), max(vec3f(cx, cy, cz), vec3f(r)))",
        "ray_slab(ox, dx, min(cx, r), max(cx, r))",
    ] {
        for span in values(expression, &scope, columns, &rows) {
            for t in span {
                bad += i32::from(!t.is_finite());
                largest = largest.max(t.abs());
            }
        }
    }
    let mut report = Report::new(SECTION, "rays_stay_finite_for_every_finite_input");
    report.at_most(
        "distances that are NaN or infinite, of 300,000 (zeros, denormals, 3e38)",
        f64::from(bad),
        0.0,
    );
    report.at_most("largest distance", largest, 1.000_001e30);
    report.finish();
}

/// Name, expression, truth, and whether it is exact.
type Shape = (&'static str, &'static str, fn(Vec3) -> f64);

const SHAPES: [Shape; 5] = [
    ("sphere", "sdf_sphere(p, 1.7)", |p| length(p) - f64::from(1.7_f32)),
    ("box", "sdf_box(p, vec3f(1.0, 2.0, 0.5))", |p| exact::to_box(p, [1.0, 2.0, 0.5])),
    ("cylinder", "sdf_cylinder(p, 1.25, 2.5)", |p| exact::to_cylinder(p, 1.25, 2.5)),
    ("torus", "sdf_torus(p, 2.0, 0.5)", |p| exact::to_torus(p, 2.0, 0.5)),
    ("capsule", "sdf_capsule(p, vec3f(-1.0, 0.5, 0.0), vec3f(1.5, 2.0, -1.0), 0.5)", |p| {
        exact::to_capsule(p, [-1.0, 0.5, 0.0], [1.5, 2.0, -1.0], 0.5)
    }),
];

const SDF: &[&str] = &["<geometry/sdf.wgsl>", "<geometry/combine.wgsl>"];

#[test]
fn distances_are_exact() {
    let points: Vec<[f32; 3]> = Random::new(4).points(20_000, 5.0);
    let mut report = Report::new(SECTION, "distances_are_exact");
    for (name, expression, truth) in SHAPES {
        let got = values(expression, &Scope { includes: SDF, ..Scope::default() }, ["x", "y", "z"], &points);
        let off = points.iter().zip(&got).map(|(p, d)| (truth(wide(*p)) - d[0]).abs()).fold(0.0, f64::max);
        report.at_most(&format!("{name}: off the true distance, within ±5"), off, 2e-6);
    }
    report.finish();
}

#[test]
fn distances_never_have_slope_above_one() {
    let mut random = Random::new(5);
    let pairs: Vec<[f32; 6]> = (0..40_000)
        .map(|_| {
            let p: [f32; 3] = random.point(4.0);
            let d: [f32; 3] = random.point(0.5);
            [p[0], p[1], p[2], p[0] + d[0], p[1] + d[1], p[2] + d[2]]
        })
        .collect();
    let mut report = Report::new(SECTION, "distances_never_have_slope_above_one");
    let a = "sdf_box(P, vec3f(1.0, 2.0, 0.5))";
    let b = "sdf_torus(P, 2.0, 0.5)";
    let mut forms: Vec<(String, String)> =
        SHAPES.iter().map(|(name, e, _)| ((*name).to_owned(), e.replace("(p,", "(P,"))).collect();
    for (name, form) in [
        ("union", "sdf_union(A, B)"),
        ("intersection", "sdf_intersection(A, B)"),
        ("difference", "sdf_difference(A, B)"),
        ("smooth union", "sdf_smooth_union(A, B, 0.7)"),
        ("smooth intersection", "sdf_smooth_intersection(A, B, 0.7)"),
        ("smooth difference", "sdf_smooth_difference(A, B, 0.7)"),
        ("blend", "sdf_blend(A, B, 0.3)"),
    ] {
        forms.push((name.to_owned(), form.replace('A', a).replace('B', b)));
    }
    for (name, form) in forms {
        let both = format!(
            "vec2f({}, {})",
            form.replace('P', "vec3f(ax, ay, az)"),
            form.replace('P', "vec3f(bx, by, bz)")
        );
        let scope = Scope { includes: SDF, ..Scope::default() };
        let got = values(&both, &scope, ["ax", "ay", "az", "bx", "by", "bz"], &pairs);
        let slope = pairs.iter().zip(&got).map(|(row, v)| {
            (v[0] - v[1]).abs() / distance(wide(triple(row)), wide(triple(&row[3..]))).max(1e-2)
        });
        report.at_most(&format!("{name}: steepest slope"), slope.fold(0.0, f64::max), 1.001);
    }
    report.finish();
}

#[test]
fn smooth_forms_stay_near_the_sharp_ones() {
    let points: Vec<[f32; 2]> = Random::new(6).points(50_000, 3.0);
    let scope = Scope { includes: SDF, ..Scope::default() };
    let mut report = Report::new(SECTION, "smooth_forms_stay_near_the_sharp_ones");
    for (name, form, sharp, sign) in [
        ("smooth union", "sdf_smooth_union(x, y, 0.8)", f64::min as fn(f64, f64) -> f64, -1.0),
        ("smooth intersection", "sdf_smooth_intersection(x, y, 0.8)", f64::max, 1.0),
        ("smooth difference", "sdf_smooth_difference(x, -y, 0.8)", f64::max, 1.0),
    ] {
        let got = values(form, &scope, ["x", "y"], &points);
        let (mut most, mut wrong) = (0.0_f64, 0.0_f64);
        for (p, v) in points.iter().zip(&got) {
            let (a, b) = (f64::from(p[0]), f64::from(p[1]));
            let away = sign * (v[0] - sharp(a, b));
            most = most.max(away);
            wrong = wrong.max(-away);
            if (a - b).abs() > 0.8001 {
                wrong = wrong.max(away.abs());
            }
        }
        report.near(
            &format!("{name}, radius .8: farthest from the sharp form, a quarter of it"),
            most,
            0.2,
            1e-3,
        );
        report.at_most(&format!("{name}: on the wrong side, or changed beyond the radius"), wrong, 1e-6);
    }
    report.finish();
}

#[test]
fn the_ellipsoid_is_a_bound() {
    let mut report = Report::new(SECTION, "the_ellipsoid_is_a_bound");
    let (mut above, mut sign, mut share) = (0.0_f64, 0, f64::INFINITY);
    let mut random = Random::new(7);
    for radii in [[1.0, 2.0, 0.5], [1.0, 1.5, 1.25], [3.0, 0.25, 2.0], [0.5, 4.0, 0.75_f32]] {
        let points: Vec<[f32; 3]> = random.points(20_000, 5.0);
        let expression = format!("sdf_ellipsoid(p, vec3f({:?}, {:?}, {:?}))", radii[0], radii[1], radii[2]);
        let got = values(&expression, &Scope { includes: SDF, ..Scope::default() }, ["x", "y", "z"], &points);
        for (p, d) in points.iter().zip(&got) {
            let truth = exact::to_ellipsoid(wide(*p), wide(radii));
            above = above.max(d[0] - truth);
            sign += i32::from(truth.abs() > 1e-5 && truth.signum() != d[0].signum());
            if truth > 1e-3 {
                share = share.min(d[0] / truth);
            }
        }
    }
    report.at_most("ellipsoid, axes up to 1 : 12: above the true signed distance by", above, 2e-6);
    report.at_most("of the wrong sign", f64::from(sign), 0.0);
    report.at_least("least part of the true distance outside, within ±5", share, 0.2);

    // Slope outside, along the gradient of the GPU's own values.
    let mut random = Random::new(8);
    let points: Vec<[f32; 3]> = random.points(40_000, 4.0);
    let fragment = "
        #include <geometry/sdf.wgsl>
        fn steep(p: vec3f, radii: vec3f) -> vec2f {
            let e = 2e-3;
            let g = vec3f(
                sdf_ellipsoid(p + vec3f(e, 0.0, 0.0), radii) - sdf_ellipsoid(p - vec3f(e, 0.0, 0.0), radii),
                sdf_ellipsoid(p + vec3f(0.0, e, 0.0), radii) - sdf_ellipsoid(p - vec3f(0.0, e, 0.0), radii),
                sdf_ellipsoid(p + vec3f(0.0, 0.0, e), radii) - sdf_ellipsoid(p - vec3f(0.0, 0.0, e), radii),
            );
            return vec2f(length(g) / (2.0 * e), sdf_ellipsoid(p, radii));
        }";
    for (name, radii, bound) in
        [("1 : 1.5 : 1", "vec3f(1.0, 1.5, 1.0)", 1.001), ("1 : 2 : .5", "vec3f(1.0, 2.0, 0.5)", 2.6)]
    {
        let scope = Scope { fragment, ..Scope::default() };
        let got = values(&format!("steep(p, {radii})"), &scope, ["x", "y", "z"], &points);
        let steepest = got.iter().filter(|v| v[1] > 0.0).map(|v| v[0]).fold(0.0, f64::max);
        report.at_most(&format!("steepest slope outside, axes {name}"), steepest, bound);
    }
    report.finish();
}

#[test]
fn distances_are_never_nan() {
    let nasty = [0.0, -0.0, 1e-40, 1e-20, 1e-7, 0.5, 1.0, -1.0, 1e7, -1e12, 1e17, -1e18, 1e18];
    let mut random = Random::new(9);
    let mut points: Vec<[f32; 3]> =
        (0..5_000).map(|_| std::array::from_fn(|_| nasty[random.bits() as usize % nasty.len()])).collect();
    points.push([0.0; 3]);
    let expressions = SHAPES.iter().map(|shape| shape.1).chain([
        "sdf_ellipsoid(p, vec3f(1.0, 2.0, 0.5))",
        "sdf_capsule(p, vec3f(1.0), vec3f(1.0), 0.5)",
        "shape_normal_tetrahedron(p, 1e-3)",
        "shape_normal_central(p, 1e-3)",
    ]);
    let fragment = "
        #include <geometry/sdf.wgsl>
        fn ball(p: vec3f) -> f32 { return sdf_sphere(p, 1.0); }
        #include <geometry/normal.wgsl> as shape with sdf = ball";
    let mut bad = 0;
    for expression in expressions {
        let got = values(expression, &Scope { fragment, ..Scope::default() }, ["x", "y", "z"], &points);
        bad += got.iter().flatten().filter(|v| !v.is_finite()).count();
    }
    let mut report = Report::new(SECTION, "distances_are_never_nan");
    report.at_most("distances and normals that are NaN or infinite, coordinates 0 to 1e18", bad as f64, 0.0);
    report.finish();
}

#[test]
fn normals_stand_upright_on_surfaces() {
    let mut random = Random::new(10);
    // On an ellipsoid, whose true normal is p / r².
    let radii: [f32; 3] = [1.0, 1.5, 0.75];
    let points: Vec<[f32; 3]> = (0..20_000)
        .map(|_| {
            let d = direction(&mut random);
            std::array::from_fn(|i| d[i] * radii[i])
        })
        .collect();
    let fragment = "
        #include <geometry/sdf.wgsl>
        fn egg(p: vec3f) -> f32 { return sdf_ellipsoid(p, vec3f(1.0, 1.5, 0.75)); }
        fn wall(p: vec3f) -> f32 { return dot(p, vec3f(0.6, 0.0, 0.8)) - 0.25; }
        fn flat_everywhere(p: vec3f) -> f32 { return 3.0 + 0.0 * p.x; }
        #include <geometry/normal.wgsl> as egg_shape with sdf = egg
        #include <geometry/normal.wgsl> as wall_shape with sdf = wall
        #include <geometry/normal.wgsl> as flat_shape with sdf = flat_everywhere";
    let scope = Scope { fragment, ..Scope::default() };
    let worst = |form: &str, normal: &dyn Fn(Vec3) -> Vec3| {
        let got = values(form, &scope, ["x", "y", "z"], &points);
        let angle = |(p, n): (&[f32; 3], &Vec<f64>)| {
            distance(normal(wide(*p)), [n[0], n[1], n[2]]) // radians, while it is small
        };
        points.iter().zip(&got).map(angle).fold(0.0, f64::max)
    };
    let egg = |p: Vec3| unit(std::array::from_fn(|i| p[i] / f64::from(radii[i] * radii[i])));
    let mut report = Report::new(SECTION, "normals_stand_upright_on_surfaces");
    report.at_most(
        "tetrahedron on an ellipsoid, reach .01: off by (rad)",
        worst("egg_shape_normal_tetrahedron(p, 0.01)", &egg),
        0.01,
    );
    report.at_most(
        "central differences there, reach .01: off by (rad)",
        worst("egg_shape_normal_central(p, 0.01)", &egg),
        3e-4,
    );
    let wall = |_: Vec3| [f64::from(0.6_f32), 0.0, f64::from(0.8_f32)];
    report.at_most(
        "tetrahedron on a plane, reach .1: off by (rad)",
        worst("wall_shape_normal_tetrahedron(p, 0.1)", &wall),
        1e-5,
    );
    report.at_most(
        "central differences there: off by (rad)",
        worst("wall_shape_normal_central(p, 0.1)", &wall),
        1e-5,
    );
    let up = |_: Vec3| [0.0, 1.0, 0.0];
    report.at_most(
        "where there is no slope: off from up",
        worst("flat_shape_normal_tetrahedron(p, 0.1)", &up),
        0.0,
    );
    report.finish();
}

#[test]
fn repetition_knows_its_cells() {
    let mut random = Random::new(11);
    let points: Vec<[f32; 3]> = random.points(50_000, 300.0);
    let scope = Scope { includes: &["<geometry/repeat.wgsl>"], ..Scope::default() };
    let spacing = [2.5, 4.0, 1.75];
    let got = values("repeat3(p, vec3f(2.5, 4.0, 1.75))", &scope, ["x", "y", "z"], &points);
    let (mut back, mut outside) = (0.0_f64, 0.0_f64);
    for (p, v) in points.iter().zip(&got) {
        for i in 0..3 {
            back = back.max((v[i] + spacing[i] * v[3 + i] - f64::from(p[i])).abs());
            outside = outside.max(v[i].abs() / spacing[i] - 0.5);
        }
    }
    let mut report = Report::new(SECTION, "repetition_knows_its_cells");
    report.at_most("cell and place in it give the point back, off by (of 300)", back, 3e-5);
    report.at_most("place outside of the cell, over its size", outside, 1e-5);

    let bounded = values(
        "repeat2_within(p.xy, vec2f(2.0), vec2i(-3, 0), vec2i(2, 5))",
        &scope,
        ["x", "y", "z"],
        &points,
    );
    let beyond = bounded.iter().filter(|v| v[2] < -3.0 || v[2] > 2.0 || v[3] < 0.0 || v[3] > 5.0).count();
    report.at_most("cells beyond the ends of a bounded row", beyond as f64, 0.0);

    let sectors = values("repeat_sectors(p.xy, 7)", &scope, ["x", "y", "z"], &points);
    let (mut turned, mut stretched, mut wrong) = (0.0_f64, 0.0_f64, 0);
    for (p, v) in points.iter().zip(&sectors) {
        let (x, y) = (f64::from(p[0]), f64::from(p[1]));
        let width = std::f64::consts::TAU / 7.0;
        turned = turned.max(v[1].atan2(v[0]).abs() / width - 0.5);
        stretched = stretched.max((v[0].hypot(v[1]) - x.hypot(y)).abs() / x.hypot(y));
        let expected = (y.atan2(x) / width).round().rem_euclid(7.0);
        let at_border = ((y.atan2(x) / width).rem_euclid(1.0) - 0.5).abs() < 1e-5;
        wrong += i32::from(!at_border && v[2] != expected);
    }
    report.at_most("sectors: turned out of the sector, over its width", turned, 1e-5);
    report.at_most("sectors: distance to the axis changed by", stretched, 1e-6);
    report.at_most("sectors misnumbered", f64::from(wrong), 0.0);
    report.finish();
}
