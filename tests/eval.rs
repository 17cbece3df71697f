//! `orogen eval`: expressions of every type over points of every type, and an error in the user's own words for each way
//! to be wrong.
//!
//! `UPDATE=1 cargo test --test eval` writes the expected error texts anew.

#![cfg(feature = "render")]

use std::path::Path;
use std::sync::LazyLock;

use orogen::render::Gpu;
use orogen::render::sample::{Column, Kind, Points, Query, Scalar, Table, evaluate};
use orogen::{Error, Library, Preset, Templates};

static GPU: LazyLock<Gpu> =
    LazyLock::new(|| Gpu::new(None).expect("the tests run on lavapipe: `cargo xtask test`"));

/// A library with a few types and functions to ask for.
fn library() -> Library {
    Library::standard().with_file(
        "test/types.wgsl",
        "struct Id { x: i32, odd: bool }
struct Hit { id: Id, at: vec2f, weights: array<f32, 2> }
fn hit(n: u32) -> Hit { return Hit(Id(-i32(n), n % 2u == 1u), vec2f(0.5, 1.5), array(0.25, 0.75)); }
fn nothing() {}
var<private> state: f32 = 1.0;
fn broken_sum(a: f32) -> f32 { return a + 1u; }
",
    )
}

fn points(header: &[&str], rows: &[&[f64]]) -> Points {
    let columns: Vec<_> = header.iter().map(|name| Column::parse(name).expect("a column")).collect();
    let values =
        rows.iter().flat_map(|row| row.iter().zip(&columns)).map(|(value, column)| match column.kind {
            Kind::U32 => Scalar::U32(*value as u32),
            Kind::I32 => Scalar::I32(*value as i32),
            _ => Scalar::F32(*value as f32),
        });
    Points { values: values.collect(), columns }
}

fn ask(
    expression: &str,
    includes: &[&str],
    preset: Option<&Preset>,
    points: &Points,
) -> Result<Table, Error> {
    let includes: Vec<_> = includes.iter().map(|include| (*include).to_owned()).collect();
    let query = Query { expression, includes: &includes, preset, points };
    evaluate(&GPU, &library(), &Templates::standard(), &query)
}

/// The table as a CSV.
fn csv(table: &Table) -> String {
    let mut text = table.columns.join(",") + "\n";
    for row in table.rows() {
        let row: Vec<_> = row.iter().map(ToString::to_string).collect();
        text += &(row.join(",") + "\n");
    }
    text
}

/// The value of an f32; NaN of anything else.
fn float(value: Scalar) -> f32 {
    if let Scalar::F32(value) = value { value } else { f32::NAN }
}

fn once(expression: &str) -> String {
    csv(&ask(expression, &["<test/types.wgsl>"], None, &Points::default()).expect("it can be evaluated"))
}

// ---- types ----

#[test]
fn scalars() {
    assert_eq!(once("1.0 / 3.0"), "value\n0.33333334\n");
    assert_eq!(once("2"), "value\n2\n");
    assert_eq!(once("~0u"), "value\n4294967295\n");
    assert_eq!(once("-3i * 5"), "value\n-15\n");
    assert_eq!(once("1 < 2"), "value\ntrue\n");
    assert_eq!(once("bitcast<f32>(0x7f800000u + u32(hit(0u).id.x))"), "value\ninf\n");
    assert_eq!(once("bitcast<f32>(1u + u32(hit(0u).id.x))"), "value\n1e-45\n");
    assert_eq!(once("16777217u"), "value\n16777217\n");
}

#[test]
fn vectors_matrices_arrays_and_structures() {
    assert_eq!(once("vec2(1, 2)"), "x,y\n1,2\n");
    assert_eq!(once("vec4f(1, 2, 3, 4).wzyx"), "x,y,z,w\n4.0,3.0,2.0,1.0\n");
    assert_eq!(once("vec3<bool>(true, false, true)"), "x,y,z\ntrue,false,true\n");
    assert_eq!(once("mat2x3f(1, 2, 3, 4, 5, 6)"), "c0_x,c0_y,c0_z,c1_x,c1_y,c1_z\n1.0,2.0,3.0,4.0,5.0,6.0\n");
    assert_eq!(once("array(vec2u(1, 2), vec2u(3, 4))"), "0.x,0.y,1.x,1.y\n1,2,3,4\n");
    assert_eq!(once("array<i32, 1>(7)"), "0\n7\n");
    assert_eq!(once("hit(7u)"), "id.x,id.odd,at.x,at.y,weights.0,weights.1\n-7,true,0.5,1.5,0.25,0.75\n");
    assert_eq!(once("hit(2u).id"), "x,odd\n-2,false\n");
}

#[test]
fn an_expression_may_carry_comments_and_lines() {
    assert_eq!(once("1 + /* a /* nested */ one */ 2 // and the rest"), "value\n3\n");
    assert_eq!(once("max(\n  1,\n  4,\n)"), "value\n4\n");
}

// ---- points ----

#[test]
fn columns_are_scalars_of_their_names_and_types() {
    let points = points(&["a", "n:u32", "i:i32"], &[&[0.5, 4e9, -2.0], &[-0.25, 3.0, 7.0]]);
    let table = ask("vec3f(a, f32(n >> 1u), f32(i / 2))", &[], None, &points).expect("it can be evaluated");
    assert_eq!(csv(&table), "x,y,z\n0.5,2000000000.0,-1.0\n-0.25,1.0,3.0\n");
}

#[test]
fn x_and_y_and_so_on_make_p() {
    let two = points(&["y", "x"], &[&[2.0, 1.0]]);
    assert_eq!(csv(&ask("p", &[], None, &two).expect("p is there")), "x,y\n1.0,2.0\n");
    let four = points(&["x", "y", "z", "w"], &[&[1.0, 2.0, 3.0, 4.0]]);
    assert_eq!(csv(&ask("p", &[], None, &four).expect("p is there")), "x,y,z,w\n1.0,2.0,3.0,4.0\n");
    let other = points(&["x", "y:u32"], &[&[1.0, 2.0]]);
    assert!(ask("p", &[], None, &other).is_err(), "p is made of f32 alone");
}

#[test]
fn special_floats_arrive_as_they_are() {
    let values = [f32::INFINITY, -0.0, f32::NAN, 1e-45, f32::MAX];
    let points = Points {
        columns: vec![Column::parse("a").expect("a column")],
        values: values.into_iter().map(Scalar::F32).collect(),
    };
    let table = ask("bitcast<u32>(a)", &[], None, &points).expect("it can be evaluated");
    let bits: Vec<_> = values.iter().map(|value| Scalar::U32(value.to_bits())).collect();
    assert_eq!(table.values, bits);
    assert_eq!(values.map(|v| Scalar::F32(v).to_string()), ["inf", "-0.0", "NaN", "1e-45", "3.4028235e38"]);
    assert_eq!(Kind::F32.parse(" -inf "), Some(Scalar::F32(f32::NEG_INFINITY)));
    assert_eq!(Kind::U32.parse("-1"), None);
}

#[test]
fn without_rows_there_are_no_results() {
    let table = ask("p", &[], None, &points(&["x", "y"], &[])).expect("it can be evaluated");
    assert_eq!(csv(&table), "x,y\n");
}

#[test]
fn pcg_gives_the_reference_values() {
    #[derive(serde::Deserialize)]
    struct Reference {
        pcg: Vec<Pair<u32>>,
        pcg2d: Vec<Pair<Vec<u32>>>,
        pcg3d: Vec<Pair<Vec<u32>>>,
    }
    #[derive(serde::Deserialize)]
    struct Pair<T> {
        x: T,
        y: T,
    }
    let reference = std::fs::read_to_string("tests/eval/hash.json").expect("it is in the repository");
    let reference: Reference = serde_json::from_str(&reference).expect("it is JSON");
    let hashed = |expression, header: &[&str], inputs: Vec<u32>| {
        let columns = header.iter().map(|name| Column::parse(name).expect("a column")).collect();
        let points = Points { columns, values: inputs.into_iter().map(Scalar::U32).collect() };
        ask(expression, &["<noise/pcg.wgsl>"], None, &points).expect("it can be evaluated").values
    };
    let outputs = |values: Vec<u32>| values.into_iter().map(Scalar::U32).collect::<Vec<_>>();
    let (x, y) = reference.pcg.into_iter().map(|pair| (pair.x, pair.y)).unzip();
    assert_eq!(hashed("pcg(n)", &["n:u32"], x), outputs(y));
    for (pairs, expression, header) in [
        (reference.pcg2d, "pcg2d(vec2u(a, b))", &["a:u32", "b:u32"] as &[_]),
        (reference.pcg3d, "pcg3d(vec3u(a, b, c))", &["a:u32", "b:u32", "c:u32"]),
    ] {
        let (x, y): (Vec<_>, Vec<_>) = pairs.into_iter().map(|pair| (pair.x, pair.y)).unzip();
        assert_eq!(hashed(expression, header, x.concat()), outputs(y.concat()));
    }
}

#[test]
fn a_million_points_of_perlin_noise_stay_in_range() {
    let columns = vec![Column::parse("x").expect("a column"), Column::parse("y").expect("a column")];
    let values = (0..1_000_000_u32)
        .flat_map(|i| [i % 1000, i / 1000].map(|cell| Scalar::F32(cell as f32 * 0.137 - 70.0)));
    let points = Points { columns, values: values.collect() };
    let table =
        ask("perlin_noise2(p, 7u)", &["<noise/perlin.wgsl>"], None, &points).expect("it can be evaluated");
    assert_eq!(table.values.len(), 1_000_000);
    let mut sum = 0.0;
    for value in &table.values {
        let value = float(*value);
        assert!((-1.0..=1.0).contains(&value), "{value}");
        sum += f64::from(value);
    }
    assert!((sum / 1e6).abs() < 0.05);
    // Each batch starts where the one before it ended.
    let tail = Points { columns: points.columns.clone(), values: points.values[1_999_990..].to_vec() };
    let last =
        ask("perlin_noise2(p, 7u)", &["<noise/perlin.wgsl>"], None, &tail).expect("it can be evaluated");
    assert_eq!(table.values[999_995..], last.values);
}

// ---- parameters ----

#[test]
fn parameters_have_the_presets_values_or_their_defaults() {
    let sun = ["<sun/sun.wgsl>"];
    let default = ask("sun.irradiance", &sun, None, &Points::default()).expect("it can be evaluated");
    assert_eq!(csv(&default), "value\n4.0\n");
    // Everything that the scene has is there, without an include.
    let mut alpine = Preset::named("alpine").expect("it is built in");
    alpine.set("sun.irradiance=7.5").expect("it is a parameter");
    for includes in [&sun as &[_], &[]] {
        let table =
            ask("sun.irradiance", includes, Some(&alpine), &Points::default()).expect("it can be evaluated");
        assert_eq!(csv(&table), "value\n7.5\n");
    }
    // In degrees in the preset, in radians in the code.
    alpine.set("sun.elevation=90").expect("it is a parameter");
    let table = ask("sun_direction()", &sun, Some(&alpine), &Points::default()).expect("it can be evaluated");
    assert!((float(table.values[1]) - 1.0).abs() < 1e-6);
}

#[test]
fn the_live_frame_is_bound_with_its_defaults() {
    let frame = ["<frame.wgsl>"];
    let table = ask("frame.resolution", &frame, None, &Points::default()).expect("it can be evaluated");
    assert_eq!(csv(&table), "x,y\n960.0,540.0\n");
    let mut preset = Preset::of_text("none", "");
    preset.set("frame.time=2.5").expect("it is a parameter");
    let table = ask("frame.time + a", &frame, Some(&preset), &points(&["a"], &[&[1.0]]))
        .expect("it can be evaluated");
    assert_eq!(csv(&table), "value\n3.5\n");
}

#[test]
fn a_scene_with_an_entry_point_and_textures_of_its_own_can_be_asked() {
    let text = "@group(1) @binding(0) var heights: texture_2d<f32>;
        #param hill.height: f32 = 12.0
        fn height() -> f32 { return hill.height; }
        @fragment fn picture() -> @location(0) vec4f { return textureLoad(heights, vec2i(0), 0) + height(); }";
    let preset = Preset::of_text("own.wgsl", text);
    let table = ask("height() * 2.0", &[], Some(&preset), &Points::default()).expect("it can be evaluated");
    assert_eq!(csv(&table), "value\n24.0\n");
}

#[test]
fn instances_can_be_included_under_a_name() {
    let include = "<fractal/fbm.wgsl> as relief with noise2 = perlin_noise2_grad";
    let table = ask(
        "relief_fbm2(p, 3.0).x",
        &["noise/perlin.wgsl", include],
        None,
        &points(&["x", "y"], &[&[0.3, 0.7]]),
    );
    match table {
        Ok(table) => assert_eq!(table.columns, ["value"]),
        Err(error) => assert!(!error.to_string().contains("OR03"), "the includes are found: {error}"),
    }
}

// ---- errors ----

/// The rendered errors of all these, in one file each.
#[test]
fn every_fault_is_told_in_the_users_own_words() {
    let types = ["<test/types.wgsl>"];
    let xy = points(&["x", "y"], &[&[1.0, 2.0]]);
    let none = Points::default();
    let mut wrong_preset = Preset::named("alpine").expect("it is built in");
    wrong_preset.set("sun.elevatoin=3").expect("it is an assignment");
    let textured = Preset::of_text(
        "own.wgsl",
        "@group(0) @binding(3) var heights: texture_2d<f32>;\nfn read() -> vec4f { return textureLoad(heights, vec2i(0), 0); }",
    );
    let named = |name: &str| Points {
        columns: vec![Column { name: name.into(), kind: Kind::F32 }],
        values: vec![Scalar::F32(0.0)],
    };
    let twice = points(&["x", "x"], &[&[1.0, 2.0]]);
    let ragged = Points { values: xy.values[..1].to_vec(), ..xy.clone() };
    let mixed = Points { values: vec![Scalar::F32(1.0), Scalar::U32(1)], ..xy.clone() };
    type Case<'a> = (&'a str, &'a str, &'a [&'a str], Option<&'a Preset>, &'a Points);
    let cases: &[Case<'_>] = &[
        ("empty", "  ", &[], None, &none),
        ("only-a-comment", "// nothing", &[], None, &none),
        ("statement", "1.0; 2.0", &[], None, &none),
        ("block", "{ 1.0 }", &[], None, &none),
        ("directive", "1.0\n#include <noise/pcg.wgsl>", &[], None, &none),
        ("bracket-open", "max(1.0, (2.0)", &[], None, &none),
        ("bracket-closed", "1.0) + (2.0", &[], None, &none),
        ("bracket-of-another-kind", "max(1.0, 2.0]", &[], None, &none),
        ("comment-open", "1.0 /* and", &[], None, &none),
        ("unknown-name", "1.0 + perlin_noise2(p, 7u)", &[], None, &xy),
        ("nearest-name", "perlin_nois2(p, 7u)", &["<noise/perlin.wgsl>"], None, &xy),
        ("types", "vec2f(1.0, 2.0) + p.x * true", &[], None, &xy),
        ("in-no-fragment", "1.0 + nowhere_at_all(p)", &types, None, &xy),
        ("unfinished", "1.0 +", &[], None, &none),
        ("two-values", "1.0, 2.0", &[], None, &none),
        ("second-line", "max(\n    1.0,\n    größe,\n)", &[], None, &none),
        ("in-the-fragment", "broken_sum(1.0)", &types, None, &none),
        ("void", "nothing()", &types, None, &none),
        ("pointer", "&state", &types, None, &xy),
        ("texture", "heights", &[], Some(&textured), &none),
        ("bindings", "read()", &[], Some(&textured), &none),
        ("too-wide", "array<mat4x4f, 300>()", &[], None, &none),
        ("parameter", "sun.elevatoin", &["<sun/sun.wgsl>"], None, &none),
        ("preset", "1.0", &[], Some(&wrong_preset), &none),
        ("include-not-found", "1.0", &["<noise/perln.wgsl>"], None, &none),
        ("include-malformed", "1.0", &["<noise/perlin.wgsl> as"], None, &none),
        ("include-two-lines", "1.0", &["<noise/pcg.wgsl>\nfn f() {}"], None, &none),
        ("include-empty", "1.0", &[" "], None, &none),
        ("column-p", "1.0", &[], None, &named("p")),
        ("column-name", "1.0", &[], None, &named("a b")),
        ("column-keyword", "1.0", &[], None, &named("while")),
        ("column-ours", "1.0", &[], None, &named("orogen_at")),
        ("column-group", "sun.irradiance", &["<sun/sun.wgsl>"], None, &named("sun")),
        ("column-twice", "1.0", &[], None, &twice),
        ("row-ragged", "x", &[], None, &ragged),
        ("row-of-another-type", "x", &[], None, &mixed),
    ];
    let mut differing = Vec::new();
    for (name, expression, includes, preset, points) in cases {
        let error = match ask(expression, includes, *preset, points) {
            Err(error) => error.render(false),
            Ok(table) => format!("no error: {table:?}"),
        };
        for generated in ["orogen_evaluate", "orogen_in", "orogen_out", "orogen_value"] {
            assert!(!error.contains(generated), "{name} shows generated code:\n{error}");
        }
        if !matches(name, &error) {
            differing.push(format!("{name}:\n{error}"));
        }
    }
    let column = Column::parse("seed:f64").expect_err("f64 is no type of a column").render(false);
    if !matches("column-type", &column) {
        differing.push(column);
    }
    assert!(differing.is_empty(), "UPDATE=1 writes these anew:\n{}", differing.join("\n"));
}

fn matches(name: &str, text: &str) -> bool {
    let path = Path::new("tests/eval").join(format!("{name}.txt"));
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, text).expect("the folder is there");
    }
    std::fs::read_to_string(&path).is_ok_and(|expected| expected == text)
}
