//! Expressions over points → numbers; numbers → rows that keep their bounds.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use orogen::render::Gpu;
use orogen::render::sample::{Column, Kind, Points, Query, Scalar, evaluate};
use orogen::{Library, Preset, Templates};

static GPU: LazyLock<Gpu> =
    LazyLock::new(|| Gpu::new(None).expect("the tests run on lavapipe: `cargo xtask test`"));

/// What an expression is evaluated among.
#[derive(Default)]
pub(crate) struct Scope<'a> {
    /// Fragments of the library: `<noise/perlin.wgsl>`, or all else that can follow `#include`.
    pub(crate) includes: &'a [&'a str],
    /// WGSL of the test's own, included as well: loops that would be slow to carry over the bus.
    pub(crate) fragment: &'a str,
    /// The values of parameters and options.
    pub(crate) preset: Option<&'a Preset>,
}

/// The value of `expression` at every point; `columns` name the coordinates (`x`, `y`, `seed:u32`, …; `x`, `y`, `z` also
/// make the vector `p`). Each row holds the scalars of one value in the order of its type.
pub(crate) fn values<const N: usize>(
    expression: &str,
    scope: &Scope<'_>,
    columns: [&str; N],
    points: &[[f32; N]],
) -> Vec<Vec<f64>> {
    let columns: Vec<Column> = columns.iter().map(|name| Column::parse(name).unwrap()).collect();
    let scalar = |(column, value): (&Column, &f32)| match column.kind {
        Kind::U32 => Scalar::U32(*value as u32),
        Kind::I32 => Scalar::I32(*value as i32),
        _ => Scalar::F32(*value),
    };
    let values = points.iter().flat_map(|point| columns.iter().zip(point)).map(scalar).collect();
    table(expression, scope, &Points { columns: columns.clone(), values })
}

/// The value of `expression`, once.
pub(crate) fn value(expression: &str, scope: &Scope<'_>) -> Vec<f64> {
    table(expression, scope, &Points::default()).remove(0)
}

/// As [`values`], of points that are typed already.
pub(crate) fn table(expression: &str, scope: &Scope<'_>, points: &Points) -> Vec<Vec<f64>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut library = Library::standard().with_folder(root.join("wgsl")).unwrap();
    let mut includes: Vec<String> = scope.includes.iter().map(|&include| include.to_owned()).collect();
    if !scope.fragment.is_empty() {
        library = library.with_file("test/fragment.wgsl", scope.fragment);
        includes.push("<test/fragment.wgsl>".to_owned());
    }
    let query = Query { expression, includes: &includes, preset: scope.preset, points };
    let table = evaluate(&GPU, &library, &Templates::standard(), &query)
        .unwrap_or_else(|error| panic!("{}", error.render(false)));
    table.rows().map(|row| row.iter().map(|scalar| number(*scalar)).collect()).collect()
}

fn number(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32(value) => f64::from(value),
        Scalar::I32(value) => f64::from(value),
        Scalar::U32(value) => f64::from(value),
        Scalar::Bool(value) => f64::from(u8::from(value)),
    }
}

/// The rows of one test: a table in `docs/accuracy.md`.
pub(crate) struct Report {
    section: &'static str,
    test: &'static str,
    rows: Vec<String>,
    broken: Vec<String>,
}

impl Report {
    /// `section`: the heading that the rows come under; `test`: the name of the test, one report each.
    pub(crate) fn new(section: &'static str, test: &'static str) -> Self {
        Self { section, test, rows: Vec::new(), broken: Vec::new() }
    }

    /// `what` was measured as `measured`, and must not be above `bound`. NaN breaks every bound.
    pub(crate) fn at_most(&mut self, what: &str, measured: f64, bound: f64) {
        self.row(what, measured, &format!("≤ {}", short(bound)), measured <= bound);
    }

    /// `what` was measured as `measured`, and must not be below `bound`.
    pub(crate) fn at_least(&mut self, what: &str, measured: f64, bound: f64) {
        self.row(what, measured, &format!("≥ {}", short(bound)), measured >= bound);
    }

    /// `what` was measured as `measured`, and must be `expected` within `tolerance`.
    pub(crate) fn near(&mut self, what: &str, measured: f64, expected: f64, tolerance: f64) {
        let bound = format!("{} ± {}", short(expected), short(tolerance));
        self.row(what, measured, &bound, (measured - expected).abs() <= tolerance);
    }

    /// `what` was measured as `measured`; nothing is promised of it.
    pub(crate) fn told(&mut self, what: &str, measured: f64) {
        self.row(what, measured, "", !measured.is_nan());
    }

    fn row(&mut self, what: &str, measured: f64, bound: &str, holds: bool) {
        let row = format!("| {what} | {} | {bound} |", short(measured));
        println!("{row}{}", if holds { "" } else { "  BROKEN" });
        if !holds {
            self.broken.push(row.clone());
        }
        self.rows.push(row);
    }

    /// Writes the rows down for `cargo xtask accuracy` and fails where one broke its bound.
    pub(crate) fn finish(self) {
        let mut text = format!("{}\n", self.section);
        for row in &self.rows {
            writeln!(text, "{row}").unwrap();
        }
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("accuracy");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("adapter"), GPU.name()).unwrap();
        fs::write(folder.join(format!("{}.txt", self.test)), text).unwrap();
        assert!(self.broken.is_empty(), "these break their bounds:\n{}", self.broken.join("\n"));
    }
}

/// Four digits, as people write them.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let decimals = (3 - value.abs().max(1e-9).log10().floor() as i32).clamp(0, 6) as usize;
        let text = format!("{value:.decimals$}");
        if text.contains('.') {
            return text.trim_end_matches('0').trim_end_matches('.').to_owned();
        }
        return text;
    }
    format!("{value:.1e}")
}
