//! What holds for any input: nothing panics, and every fault is shown at a place inside of its text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use orogen::source::preset_names;
use orogen::syntax::{Value, lex, parse_directive, parse_fragment};
use orogen::{Bake, Error, Library, Preset, bake};
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestCaseError;

/// So many cases; with `CASES=20` in the environment, twenty times as many.
fn cases(some: u32) -> ProptestConfig {
    let times = std::env::var("CASES").ok().and_then(|times| times.parse::<u32>().ok()).unwrap_or(1);
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(some * times) }
}

/// Every label lies inside of its text and at characters, and all of it can be told to people and to tools.
fn well_told(error: &Error) -> Result<(), TestCaseError> {
    prop_assert!(!error.diagnostics().is_empty());
    for diagnostic in error.diagnostics() {
        for label in &diagnostic.labels {
            let text = &error.files().get(label.file).text;
            prop_assert!(text.get(label.span.range()).is_some(), "{label:?} of {}", diagnostic.message);
        }
    }
    let told = error.render(false);
    for diagnostic in error.diagnostics().iter().take(50) {
        prop_assert!(told.contains(diagnostic.code), "{told}");
    }
    for line in error.json_lines().lines() {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        for span in line["spans"].as_array().unwrap() {
            let place =
                |line: &str, column: &str| (span[line].as_u64().unwrap(), span[column].as_u64().unwrap());
            let (start, end) = (place("line", "column"), place("end_line", "end_column"));
            prop_assert!(start <= end && start.0 >= 1 && start.1 >= 1);
        }
    }
    Ok(())
}

fn compose(library: &Library, preset: &Preset, bake: &Bake) -> Result<(), TestCaseError> {
    match orogen::compose(library, preset, bake) {
        Ok(shader) => {
            // What the map says was copied, was.
            let baked = &shader.checked().baked;
            for segment in baked.map.segments().iter().filter(|segment| segment.copied) {
                let source = baked.composition.files.get(segment.file).slice(segment.from);
                prop_assert_eq!(&baked.text[segment.out.range()], source);
            }
            Ok(())
        }
        Err(error) => well_told(&error),
    }
}

// ---- directives ----

/// A directive that is right.
fn directive() -> impl Strategy<Value = String> {
    let number = "-?(0|[1-9][0-9]{0,4})(\\.[0-9]{1,3})?(e-?[0-9])?";
    prop_oneof![
        ("[a-z]{1,5}", "[a-z]{1,5}", number)
            .prop_map(|(a, b, n)| format!("#param {a}.{b}: f32 = {n}, unit m, log, live")),
        ("[a-z]{1,5}", number, number)
            .prop_map(|(a, m, n)| format!("  # param {a}.b : vec2f=({m} , {n}) // text")),
        ("[a-z]{1,5}", "[a-z]{1,5}").prop_map(|(a, b)| format!("#option {a}.{b} = x{b} {{ x{b}, y{a} }}")),
        ("[a-z/]{1,9}", "[a-z]{1,5}")
            .prop_map(|(a, b)| format!("#include <{a}> as {b} with {b} = {b}, x2 = y")),
        ("[a-z]{1,5}", "[a-z]{1,5}")
            .prop_map(|(a, b)| format!("#slot {a}: fn(p: vec2<f32>, q: {b}) -> array<{b}, 3>")),
        "[a-z]{1,5}".prop_map(|a| format!("#if !({a}.b == c) && {a} >= 3 || false")),
        Just("#option quality = 8, range 1 .. 16".to_owned()),
    ]
}

/// Deletes, doubles, swaps or puts in a few characters.
fn broken(text: &str, edits: &[(u8, Index, Index)]) -> String {
    const PIECES: [&str; 24] = [
        "#", "(", ")", "<", ">", "\"", ",", ".", "=", "..", "//", "/*", "*/", "\n", "\r\n", "é", "🏔", "0x",
        "1e99", "_", "{", "}", ";", "#if a\n",
    ];
    let mut characters: Vec<String> = text.chars().map(String::from).collect();
    for (kind, at, other) in edits {
        if characters.is_empty() {
            break;
        }
        let (at, other) = (at.index(characters.len()), other.index(characters.len()));
        match kind % 4 {
            0 => drop(characters.remove(at)),
            1 => characters.insert(at, characters[other].clone()),
            2 => characters.swap(at, other),
            _ => characters.insert(at, PIECES[other % PIECES.len()].into()),
        }
    }
    characters.concat()
}

fn edits(most: usize) -> impl Strategy<Value = Vec<(u8, Index, Index)>> {
    prop::collection::vec((any::<u8>(), any::<Index>(), any::<Index>()), 1..most)
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn a_right_directive_is_read(line in directive()) {
        let fragment = parse_fragment(line.as_str().into());
        let faults: Vec<_> = fragment.errors.iter().map(ToString::to_string).collect();
        let closed = faults.iter().all(|fault| fault.contains("#endif"));
        prop_assert!(closed, "{line}: {faults:?}");
        prop_assert_eq!(fragment.directives.len(), 1);
    }

    #[test]
    fn any_line_is_a_directive_or_refused_inside_of_it(line in directive(), edits in edits(6)) {
        let text = broken(&line, &edits);
        compose(&Library::empty(), &Preset::of_text("any.wgsl", &text), &Bake::constants())?;
    }

    #[test]
    fn any_text_after_a_sign_is_read_or_refused(name in "(include|param|option|slot|if|elif|else|endif|)", text in "\\PC{0,60}") {
        let line = format!("#{name}{text}");
        let _ = parse_directive(&line, 0, "");
        compose(&Library::empty(), &Preset::of_text("any.wgsl", &line), &Bake::constants())?;
    }
}

// ---- conditions ----

/// A condition and what it must come to, under `#option n = 7`, `on = true`, `mode = b { a, b, c }`.
#[derive(Debug, Clone)]
enum Cond {
    Leaf(String, bool),
    Not(Box<Cond>),
    Two(&'static str, Box<Cond>, Box<Cond>),
}

impl Cond {
    fn value(&self) -> bool {
        match self {
            Self::Leaf(_, value) => *value,
            Self::Not(inner) => !inner.value(),
            Self::Two(operator, left, right) => match *operator {
                "||" => left.value() || right.value(),
                "&&" => left.value() && right.value(),
                "==" => left.value() == right.value(),
                _ => left.value() != right.value(),
            },
        }
    }

    /// How tightly its outermost operator binds.
    fn level(&self) -> u8 {
        match self {
            Self::Two("||", ..) => 1,
            Self::Two("&&", ..) => 2,
            Self::Two(..) => 3,
            Self::Leaf(text, _) if text.contains(['<', '>']) => 4,
            Self::Leaf(text, _) if text.contains('=') => 3,
            Self::Leaf(..) | Self::Not(_) => 5,
        }
    }

    /// With brackets only where the precedence asks for them.
    fn text(&self, least: u8) -> String {
        let text = match self {
            Self::Leaf(text, _) => text.clone(),
            Self::Not(inner) => format!("!{}", inner.text(5)),
            // From the left: an operator of the same level on the right needs brackets.
            Self::Two(operator, left, right) => {
                format!("{} {operator} {}", left.text(self.level()), right.text(self.level() + 1))
            }
        };
        if self.level() < least { format!("({text})") } else { text }
    }
}

fn leaf() -> impl Strategy<Value = Cond> {
    let compare = |operator: &str, a: f64, b: f64| match operator {
        "==" => a == b,
        "!=" => a != b,
        "<" => a < b,
        "<=" => a <= b,
        ">" => a > b,
        _ => a >= b,
    };
    let operator = prop::sample::select(vec!["==", "!=", "<", "<=", ">", ">="]);
    let operator_too = operator.clone();
    prop_oneof![
        Just(Cond::Leaf("true".into(), true)),
        Just(Cond::Leaf("false".into(), false)),
        Just(Cond::Leaf("g.on".into(), true)),
        (operator, -10i32..20, any::<bool>()).prop_map(move |(operator, n, swapped)| if swapped {
            Cond::Leaf(format!("{n}.0 {operator} g.n"), compare(operator, f64::from(n), 7.0))
        } else {
            Cond::Leaf(format!("g.n {operator} {n}"), compare(operator, 7.0, f64::from(n)))
        }),
        (operator_too, 0..3usize).prop_map(move |(operator, choice)| {
            let text = format!("mode {operator} {}", ["a", "b", "c"][choice]);
            Cond::Leaf(text, compare(operator, 1.0, choice as f64))
        }),
    ]
}

fn condition() -> impl Strategy<Value = Cond> {
    leaf().prop_recursive(6, 32, 2, |inner| {
        let operator = prop::sample::select(vec!["||", "&&", "==", "!="]);
        prop_oneof![
            inner.clone().prop_map(|inner| Cond::Not(Box::new(inner))),
            (operator, inner.clone(), inner).prop_map(|(o, a, b)| Cond::Two(o, Box::new(a), Box::new(b))),
        ]
    })
}

const OPTIONS: &str = "#option g.n = 7\n#option g.on = true\n#option mode = b { a, b, c }\n";

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn a_condition_comes_to_what_it_must(condition in condition()) {
        let text = format!("{OPTIONS}#if {}\nconst IN = 1;\n#else\nconst OUT = 1;\n#endif\n", condition.text(0));
        let preset = Preset::of_text("condition.wgsl", &text);
        let shader = orogen::compose(&Library::empty(), &preset, &Bake::constants());
        let shader = shader.map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(shader.wgsl().contains("IN"), condition.value(), "{}", text);
    }

    #[test]
    fn a_broken_condition_is_refused_or_decided(condition in condition(), edits in edits(5)) {
        let text = format!("{OPTIONS}#if {}\n#endif\n", broken(&condition.text(0), &edits));
        compose(&Library::empty(), &Preset::of_text("condition.wgsl", &text), &Bake::constants())?;
    }
}

// ---- presets ----

fn json() -> impl Strategy<Value = serde_json::Value> {
    use serde_json::Value as J;
    let key = "(orogen|about|extends|scene|set|sun|sky|\\PC{0,6})";
    let leaf = prop_oneof![
        Just(J::Null),
        any::<bool>().prop_map(J::from),
        any::<i64>().prop_map(J::from),
        any::<f64>().prop_map(J::from),
        "(alpine|scene/landscape.wgsl|\\PC{0,8})".prop_map(J::from),
    ];
    leaf.prop_recursive(5, 40, 6, move |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..5).prop_map(J::from),
            prop::collection::vec((key, inner), 0..6).prop_map(|pairs| pairs.into_iter().collect()),
        ]
    })
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn any_json_is_a_preset_or_refused_inside_of_it(json in json()) {
        if let Err(error) = Preset::parse("any.json", &json.to_string()) {
            well_told(&error)?;
        }
    }

    #[test]
    fn any_text_is_a_preset_or_refused_inside_of_it(text in "[\\{\\}\\[\\],:\"a-z0-9é\\\\ \\n]{0,60}") {
        if let Err(error) = Preset::parse("any.json", &text) {
            well_told(&error)?;
        }
    }

    #[test]
    fn a_broken_preset_is_refused_inside_of_it(which: Index, edits in edits(4)) {
        let names = preset_names();
        let name = names[which.index(names.len())];
        let text = std::fs::read_to_string(format!("presets/{name}.json")).unwrap();
        match Preset::parse("broken.json", &broken(&text, &edits)) {
            Err(error) => well_told(&error)?,
            Ok(preset) => {
                let library = Library::standard();
                let survey = orogen::Compose::default().survey(&library, &preset);
                survey.map(|_| ()).or_else(|error| well_told(&error))?;
            }
        }
    }

    #[test]
    fn any_setting_is_taken_or_refused(assignment in "\\PC{0,20}", value in "\\PC{0,20}") {
        let mut preset = Preset::named("alpine").unwrap();
        for assignment in [assignment, format!("sun.azimuth={value}"), format!("sky.zenith={value}")] {
            if let Err(error) = preset.set(&assignment) {
                well_told(&error)?;
            }
        }
        let survey = orogen::Compose::default().survey(&Library::standard(), &preset);
        survey.map(|_| ()).or_else(|error| well_told(&error))?;
    }

    #[test]
    fn any_glob_matches_or_is_refused(live in "[a-z.*?é]{0,12}", overrides in "\\PC{0,8}") {
        let text = "#param sun.power: f32 = 1.0\n#param sky.color: vec3f = (1, 1, 1)\nfn f() -> vec3f { return sky.color * sun.power; }\n";
        let bake = Bake::live([live]).with_overrides([overrides]);
        compose(&Library::empty(), &Preset::of_text("globs.wgsl", text), &bake)?;
    }
}

// ---- whole compositions ----

/// Deletes, doubles, swaps or puts in a few tokens or lines.
fn broken_by(text: &str, lines: bool, edits: &[(u8, Index, Index)]) -> String {
    let mut pieces: Vec<&str> = if lines {
        text.split_inclusive('\n').collect()
    } else {
        lex(text).iter().map(|(_, span)| &text[span.range()]).collect()
    };
    for (kind, at, other) in edits {
        if pieces.is_empty() {
            break;
        }
        let (at, other) = (at.index(pieces.len()), other.index(pieces.len()));
        match kind % 3 {
            0 => drop(pieces.remove(at)),
            1 => pieces.insert(at, pieces[other]),
            _ => pieces.swap(at, other),
        }
    }
    pieces.concat()
}

proptest! {
    #![proptest_config(cases(120))]

    #[test]
    fn a_broken_fragment_composes_or_is_refused_inside_of_it(
        which: Index, root: Index, how in 0..3, live: bool, edits in edits(8)
    ) {
        let library = Library::standard();
        let paths = library.modules();
        let path = &paths[which.index(paths.len())];
        let text = library.find(path).unwrap().text;
        let broken = match how {
            0 => broken(&text, &edits),
            1 => broken_by(&text, false, &edits),
            _ => broken_by(&text, true, &edits),
        };
        let library = library.with_file(path.as_str(), broken);
        // The fragment itself, or another one that may include it.
        let root = if live { path } else { &paths[root.index(paths.len())] };
        let bake = if live { Bake::live(["*"]) } else { Bake::constants() };
        compose(&library, &Preset::of_module(root), &bake)?;
    }
}

// ---- values ----

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn a_float_is_the_same_in_every_baking(bits: [u32; 3]) {
        let floats = bits.map(f32::from_bits);
        prop_assume!(floats.iter().all(|float| float.is_finite()));
        let value = Value::from_floats(orogen::syntax::Type::Vec3f, &floats).unwrap();
        let spelled = floats.map(|float| format!("{float:?}"));
        let text = format!(
            "#param p.v: vec3f = ({})\n@fragment fn main() -> @location(0) vec4f {{ return vec4f(p.v, 1.0); }}\n",
            spelled.join(", ")
        );
        let preset = Preset::of_text("value.wgsl", &text);
        for bake in [Bake::constants(), Bake::constants().with_overrides(["*"]), Bake::live(["*"]).as_variables()] {
            let shader = orogen::compose(&Library::empty(), &preset, &bake);
            let shader = shader.map_err(|error| TestCaseError::fail(error.to_string()))?;
            let module = &shader.checked().module;
            let mut literals: Vec<u32> = module
                .global_expressions
                .iter()
                .filter_map(|(_, expression)| match expression {
                    naga::Expression::Literal(naga::Literal::F32(value)) => Some(value.to_bits()),
                    _ => None,
                })
                .collect();
            let mut wanted = bits.to_vec();
            literals.sort_unstable();
            literals.dedup();
            wanted.sort_unstable();
            wanted.dedup();
            for bits in &wanted {
                prop_assert!(literals.contains(bits), "{} in {}", f32::from_bits(*bits), shader.wgsl());
            }
        }
        let shader = orogen::compose(&Library::empty(), &preset, &Bake::live(["*"])).unwrap();
        let bytes: Vec<u8> = floats.iter().flat_map(|float| float.to_le_bytes()).collect();
        prop_assert_eq!(&shader.uniform_bytes(&preset).unwrap()[..12], &bytes[..]);
        prop_assert!(bake::literal(&value).starts_with("vec3f("));
    }
}
