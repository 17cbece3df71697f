//! Part 2: how exactly each tool says where a fault is.
//!
//! Faults of eight kinds are put at random places of a module tree, one a tree, the same in every dialect. What a tool prints for
//! a person is held against where the fault was put: file, line, column (in characters).

use std::collections::HashMap;

use fastrand::Rng;
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor, ShaderDefValue};
use orogen::{Bake, Library, Preset, check, compose};
use wesl::{CompileOptions, Feature, Features, VirtualResolver, Wesl};

use crate::Outcome;
use crate::graph::{Dialect, Plan, Settings, Shape, choice, import, settings};
use crate::page::{Section, table};
use crate::tool::path;

pub(crate) const TITLE: &str = "Where errors are told";

const SEED: u64 = 20_261_129;
const EACH: usize = 30;
/// What Orogen promises on file, line and column, in percent.
const BAR: f64 = 99.0;
const TREE: Plan = Plan { shape: Shape::Diamond, modules: 20, functions: 5 };
const DIALECTS: [Dialect; 3] = [Dialect::Orogen, Dialect::NagaOil, Dialect::Wesl];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    UndefinedName,
    TypeError,
    ArgumentCount,
    MissingImport,
    Condition,
    Duplicate,
    Layout,
    MultiByte,
}

const KINDS: [Kind; 8] = [
    Kind::UndefinedName,
    Kind::TypeError,
    Kind::ArgumentCount,
    Kind::MissingImport,
    Kind::Condition,
    Kind::Duplicate,
    Kind::Layout,
    Kind::MultiByte,
];

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::UndefinedName => "undefined name",
            Self::TypeError => "type error",
            Self::ArgumentCount => "wrong argument count",
            Self::MissingImport => "missing include or import",
            Self::Condition => "bad condition",
            Self::Duplicate => "duplicate declaration",
            Self::Layout => "bad layout attribute",
            Self::MultiByte => "undefined name after multi-byte text",
        }
    }
}

/// A stretch of one line, in characters from 1; the end is the last that is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Place {
    line: usize,
    first: usize,
    last: usize,
}

/// A fault in one dialect: the module's text with it, and the places that are right.
#[derive(Clone, Debug)]
struct Fault {
    module: usize,
    text: String,
    right: Vec<Place>,
}

/// What a tool has told of a fault.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Told {
    file: String,
    line: usize,
    column: usize,
}

/// Of how many faults what was right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Score {
    faults: usize,
    noticed: usize,
    file: usize,
    line: usize,
    column: usize,
}

impl Score {
    fn add(&mut self, fault: &Fault, told: Option<&Told>) {
        self.faults += 1;
        let Some(told) = told else { return };
        self.noticed += 1;
        // Each next one counts only where the one before is right: a line of another file is right by chance.
        if told.file != format!("m{}", fault.module) {
            return;
        }
        self.file += 1;
        if !fault.right.iter().any(|right| right.line == told.line) {
            return;
        }
        self.line += 1;
        let is_in =
            |right: &Place| right.line == told.line && (right.first..=right.last).contains(&told.column);
        self.column += usize::from(fault.right.iter().any(is_in));
    }

    fn sum(scores: &[Self]) -> Self {
        let of = |part: fn(&Self) -> usize| scores.iter().map(part).sum();
        Self {
            faults: of(|score| score.faults),
            noticed: of(|score| score.noticed),
            file: of(|score| score.file),
            line: of(|score| score.line),
            column: of(|score| score.column),
        }
    }

    fn percent(&self, part: usize) -> f64 {
        100.0 * part as f64 / self.faults.max(1) as f64
    }

    /// The least of file, line and column, in percent.
    pub(crate) fn least(&self) -> f64 {
        self.percent(self.column)
    }
}

/// The scores of each dialect's tool, kind by kind.
pub(crate) fn scores(each: usize) -> Outcome<Vec<[Score; 3]>> {
    let mut rng = Rng::with_seed(SEED);
    let mut scores = Vec::new();
    for kind in KINDS {
        let mut of_kind = [Score::default(); 3];
        for _ in 0..each {
            let seed = rng.u64(..);
            for (dialect, score) in DIALECTS.into_iter().zip(&mut of_kind) {
                // The same choices in every dialect.
                let fault = fault(kind, dialect, &mut Rng::with_seed(seed))?;
                let told = told(dialect, &fault)?;
                if std::env::var_os("PEERS_FAULTS").is_some() {
                    let before = score.column;
                    score.add(&fault, told.as_ref());
                    if score.column == before {
                        eprintln!(
                            "{dialect:?} {kind:?} m{} {:?} but told {told:?}",
                            fault.module, fault.right
                        );
                    }
                } else {
                    score.add(&fault, told.as_ref());
                }
            }
        }
        scores.push(of_kind);
    }
    Ok(scores)
}

/// The whole score of each tool.
pub(crate) fn totals(scores: &[[Score; 3]]) -> [Score; 3] {
    [0, 1, 2].map(|tool| Score::sum(&scores.iter().map(|score| score[tool]).collect::<Vec<_>>()))
}

pub(crate) fn measure() -> Outcome<Section> {
    let scores = scores(EACH)?;
    let totals = totals(&scores);
    let cells = |score: &Score| {
        let [file, line, column] = [score.file, score.line, score.column].map(|part| score.percent(part));
        format!("{file:.0} / {line:.0} / {column:.0}")
    };
    let mut rows: Vec<[String; 4]> = KINDS
        .iter()
        .zip(&scores)
        .map(|(kind, of)| [kind.name().to_owned(), cells(&of[0]), cells(&of[1]), cells(&of[2])])
        .collect();
    rows.push(["**all**".to_owned(), cells(&totals[0]), cells(&totals[1]), cells(&totals[2])]);
    let noticed = totals.map(|score| format!("{:.0}", score.percent(score.noticed)));
    let [ours, oil, wesl] = noticed;
    rows.push(["told any place at all".to_owned(), ours, oil, wesl]);
    let verdict = if totals[0].least() >= BAR { "kept" } else { "**missed**" };
    let text = format!(
        "{} faults of {} kinds, each put at a random place (seed {SEED}) of a tree of {} modules, the same in every dialect. The place \
         in the head of what each tool prints for a person, to which an editor jumps, is held against where the fault was put: \
         percent of faults whose file / file and line / file, line and column are right. A column is right if it lies in the wrong \
         expression, statement, attribute or directive; of a name that is declared twice either place is right, and of a missing \
         import its use is, too. `naga_oil` validates (`Composer::default()`), `wesl` has its validation and its source map on, and \
         unknown features are errors to it; it knows no types, so naga finds the rest in its output, whose lines are nobody's. \
         Where `naga_oil` underlines several stretches, its head is the first of them, often the whole function's.\n\nBar: Orogen at least {BAR:.0} % on all three: {verdict}.\n\n{}",
        totals[0].faults,
        KINDS.len(),
        TREE.modules,
        table(["fault", "orogen", "naga_oil", "wesl"], &rows),
    );
    Ok(Section { title: TITLE, text })
}

/// A fault of `kind`, at a place that `rng` picks.
fn fault(kind: Kind, dialect: Dialect, rng: &mut Rng) -> Outcome<Fault> {
    let module = rng.usize(..TREE.modules);
    let function = rng.usize(..TREE.functions);
    let text = TREE.module(dialect, module, 0);
    let name = format!("m{module}_f{function}");
    let body = text.find(&format!("fn {name}(")).ok_or("the module has not that function")?;
    let end = body + text[body..].find("\n}\n").ok_or("the function does not end")?;
    let new = |text: String, right: Vec<Place>| Ok(Fault { module, text, right });
    // Puts `with` in the place of `what`, in the function; `part` of it is wrong.
    let replaced = |what: &str, with: &str, part: &str| {
        let at = body + text[body..end].find(what).ok_or_else(|| format!("`{what}` is not in {name}"))?;
        let changed = [&text[..at], with, &text[at + what.len()..]].concat();
        let wrong = at + with.find(part).ok_or("no such part")?;
        let right = vec![place(&changed, wrong, part.len())];
        new(changed, right)
    };
    // Puts a line that uses something at the function's start.
    let with_line = |text: &str, line: &str| {
        let start = "    var amplitude = 0.5;";
        let body = text.find(&format!("fn {name}(")).unwrap_or(0);
        let at = body + text[body..].find(start).unwrap_or(0);
        [&text[..at], line, "\n", &text[at..]].concat()
    };
    // Before the functions, after imports.
    let head = text.find("\n/// Value 0 ").map_or(0, |at| at + 1);
    match kind {
        Kind::UndefinedName => {
            let (what, with, part) = *pick(rng, &NAMES);
            replaced(what, with, part)
        }
        Kind::MultiByte => {
            let (what, with, part) = *pick(rng, &NAMES);
            let words = pick(rng, &["Größe", "높이 → 낮음", "Σ αβγ ≤ 1", "🏔️ 🌊", "é è ñ"]);
            let fault = replaced(what, with, part)?;
            let Some(right) = fault.right.first() else { return Err("no place".into()) };
            // The comment comes first on the line, after its indentation.
            let start = fault.text.split_inclusive('\n').take(right.line - 1).map(str::len).sum::<usize>();
            let indent = fault.text[start..].chars().take_while(|c| *c == ' ').count();
            let comment = format!("/* {words} */ ");
            let at = start + indent;
            let changed = [&fault.text[..at], &comment, &fault.text[at..]].concat();
            let shift = comment.chars().count();
            let right = Place { first: right.first + shift, last: right.last + shift, ..*right };
            new(changed, vec![right])
        }
        Kind::TypeError => {
            let phase = format!("x * f32(octave + {function}) + ");
            let (a, b) = (format!("{phase}0.25"), format!("{phase}true"));
            let ways: [(&str, &str, &str); 8] = [
                (&a, &b, &b),
                ("sum * 0.5 + 0.5", "sum * false + 0.5", "sum * false + 0.5"),
                ("weight > 0.75", "weight > 2u", "weight > 2u"),
                ("amplitude *= 0.5;", "amplitude *= false;", "amplitude *= false;"),
                ("return sum;", "return octaves;", "return octaves;"),
                ("if weight > 0.75", "if weight", "if weight"),
                ("amplitude *= 0.5;", "amplitude = octaves;", "amplitude = octaves;"),
                ("var amplitude = 0.5;", "var amplitude: i32 = 0.5;", "var amplitude: i32 = 0.5;"),
            ];
            let (what, with, part) = *pick(rng, &ways);
            replaced(what, with, part)
        }
        Kind::ArgumentCount => {
            let clamp = "clamp(sum * 0.5 + 0.5, 0.0, 1.0)";
            let includes = TREE.includes(module);
            let below = match includes.as_slice() {
                [] => "x * 0.5".to_owned(),
                some => format!("m{}_f{function}(x * 0.5, octaves)", some[function % some.len()]),
            };
            let fewer = below.replace(", octaves)", ")");
            let more = below.replace(", octaves)", ", octaves, 2.0)");
            let mut ways = vec![
                (clamp, "clamp(sum * 0.5 + 0.5, 0.0)"),
                (clamp, "clamp(sum * 0.5 + 0.5, 0.0, 1.0, 2.0)"),
            ];
            if !includes.is_empty() {
                ways.extend([(below.as_str(), fewer.as_str()), (below.as_str(), more.as_str())]);
            }
            let (what, with) = *pick(rng, &ways);
            replaced(what, with, with)
        }
        Kind::MissingImport => {
            let missing = TREE.modules + rng.usize(1..100);
            let line = import(dialect, missing, 0..1);
            let at = text.find("// Module").and_then(|at| Some(at + text[at..].find('\n')? + 1)).unwrap_or(0);
            let changed = [&text[..at], &line, &text[at..]].concat();
            let call = format!("m{missing}_f0(x, octaves)");
            let changed = with_line(&changed, &format!("    sum += {call};"));
            let used = changed.find(&call).ok_or("it is not used")?;
            let right = vec![place(&changed, at, line.trim_end().len()), place(&changed, used, call.len())];
            new(changed, right)
        }
        Kind::Condition => {
            let constant = |value| format!("const m{module}_rough: f32 = {value};\n");
            let lines = choice(dialect, &constant("2.0"), &constant("3.0"));
            let wrong = match dialect {
                Dialect::NagaOil => lines.replace("FINE", pick::<&str>(rng, &["FIEN", "FINER", "FIN"])),
                _ => lines.replace("fine", pick::<&str>(rng, &["fien", "finer", "fin"])),
            };
            let changed = [&text[..head], &wrong, "\n", &text[head..]].concat();
            let end = match dialect {
                Dialect::Wesl => wrong.find(')').map_or(0, |at| at + 1),
                _ => wrong.find('\n').unwrap_or(0),
            };
            let right = vec![place(&changed, head, end)];
            // Someone has to know the options that the condition asks for.
            new(changed, right)
        }
        Kind::Duplicate => {
            let again = format!("\nfn {name}(x: f32, octaves: i32) -> f32 {{\n    return x;\n}}\n");
            let changed = text.clone() + &again;
            let first = place(&changed, body + 3, name.len());
            let second = place(&changed, text.len() + 4, name.len());
            new(changed, vec![first, second])
        }
        Kind::Layout => {
            let attribute = *pick(rng, &["@align(3)", "@size(2)", "@align(0)", "@size(-4)"]);
            let lines =
                format!("struct M{module}Pair {{\n    {attribute} first: f32,\n    second: f32,\n}}\n\n");
            let changed = [&text[..head], &lines, &text[head..]].concat();
            let changed = with_line(&changed, &format!("    sum += M{module}Pair(x, 0.5).second;"));
            let at = changed.find(attribute).ok_or("the attribute is not there")?;
            let right = vec![place(&changed, at, attribute.len() + " first: f32".len())];
            new(changed, right)
        }
    }
}

/// What is there, what is put there instead, and the part of it that is wrong.
const NAMES: [(&str, &str, &str); 6] = [
    ("sin(phase)", "sin(phaze)", "phaze"),
    ("cos(phase * 1.7)", "cos(phas * 1.7)", "phas"),
    ("clamp(sum", "clamp(sun", "sun"),
    ("if weight > 0.75", "if wieght > 0.75", "wieght"),
    ("mix(", "mxi(", "mxi"),
    ("octave < octaves", "octave < octavs", "octavs"),
];

fn pick<'a, T>(rng: &mut Rng, of: &'a [T]) -> &'a T {
    &of[rng.usize(..of.len())]
}

/// Where `length` bytes from `at` on are, on one line.
fn place(text: &str, at: usize, length: usize) -> Place {
    let before = &text[..at];
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let first = text[start..at].chars().count() + 1;
    let characters = text[at..at + length].chars().count();
    Place { line: before.matches('\n').count() + 1, first, last: first + characters.max(1) - 1 }
}

/// Composes the tree with the fault in it.
fn told(dialect: Dialect, fault: &Fault) -> Outcome<Option<Told>> {
    let mut graph = TREE.graph(dialect);
    for file in &mut graph.modules {
        if file.name == format!("m{}", fault.module) {
            file.text = fault.text.as_str().into();
        }
    }
    let values = Settings::default();
    match dialect {
        Dialect::Orogen => {
            let mut library = Library::empty();
            for file in graph.modules {
                library = library.with_file(format!("{}.wgsl", file.name), file.text);
            }
            if let Some(text) = settings(dialect, values) {
                library = library.with_file("settings.wgsl", text);
            }
            let composed = compose(&library, &Preset::of_text("root.wgsl", &graph.root), &Bake::constants());
            Ok(composed.err().and_then(|error| rendered(&error.render(false), "┌─ ")))
        }
        Dialect::NagaOil => {
            let mut composer = Composer::default().with_capabilities(check::capabilities());
            for file in &graph.modules {
                let added = composer.add_composable_module(ComposableModuleDescriptor {
                    source: &file.text,
                    file_path: &file.name,
                    ..Default::default()
                });
                if let Err(error) = added {
                    return Ok(rendered(&error.emit_to_string(&composer), "┌─ "));
                }
            }
            let shader_defs = HashMap::from([
                ("FINE".to_owned(), ShaderDefValue::Bool(values.fine)),
                ("GAIN".to_owned(), ShaderDefValue::Int(values.gain)),
            ]);
            let root = NagaModuleDescriptor {
                source: &graph.root,
                file_path: "root",
                shader_defs,
                ..Default::default()
            };
            let made = composer.make_naga_module(root);
            Ok(made.err().and_then(|error| rendered(&error.emit_to_string(&composer), "┌─ ")))
        }
        Dialect::Wesl => {
            let mut resolver = VirtualResolver::new();
            for file in &graph.modules {
                resolver.add_module(path(&file.name), (&*file.text).into());
            }
            resolver.add_module(path("root"), graph.root.as_str().into());
            if let Some(text) = settings(dialect, values) {
                resolver.add_module(path("settings"), text.into());
            }
            let flags = HashMap::from([("fine".to_owned(), values.fine.into())]);
            let features = Features { flags, default: Feature::Error };
            let mut compiler = Wesl::new_barebones().set_custom_resolver(resolver);
            compiler.set_options(CompileOptions { features, ..CompileOptions::default() });
            compiler.set_mangler(wesl::ManglerKind::Escape);
            compiler.use_sourcemap(true);
            match compiler.compile(&path("root")) {
                Err(error) => Ok(rendered(&plain(&error.to_string()), "--> ")),
                Ok(made) => {
                    let text = made.to_string();
                    let error = match naga::front::wgsl::parse_str(&text) {
                        Err(error) => error.emit_to_string_with_path(&text, "output"),
                        Ok(module) => {
                            let flags = naga::valid::ValidationFlags::all();
                            match naga::valid::Validator::new(flags, check::capabilities()).validate(&module)
                            {
                                Ok(_) => return Ok(None),
                                Err(error) => error.emit_to_string_with_path(&text, "output"),
                            }
                        }
                    };
                    Ok(rendered(&error, "┌─ "))
                }
            }
        }
    }
}

/// The first place that a rendered error names: after `mark`, `file:line:column`.
fn rendered(error: &str, mark: &str) -> Option<Told> {
    let at = error.find(mark)? + mark.len();
    let line = error[at..].lines().next()?.trim();
    let mut parts = line.rsplitn(3, ':');
    let (column, line, file) = (parts.next()?, parts.next()?, parts.next()?);
    // Extensions and the root of a path are not the point: `m7.wgsl`, `package::m7`, `/m7`.
    let file = file.rsplit(['/', ':']).next().unwrap_or(file).trim_end_matches(".wgsl");
    Some(Told { file: file.to_owned(), line: line.parse().ok()?, column: column.parse().ok()? })
}

/// `text` without terminal colours.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        if letter == '\u{1b}' {
            letters.by_ref().find(char::is_ascii_alphabetic);
        } else {
            plain.push(letter);
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_in_characters() {
        let text = "one\n  /* é */ two\n";
        let at = text.find("two").expect("it is there");
        assert_eq!(place(text, at, 3), Place { line: 2, first: 11, last: 13 });
    }

    #[test]
    fn a_rendered_place_is_read() {
        let told = rendered("error: x\n   ┌─ m3.wgsl:12:5\n", "┌─ ");
        assert_eq!(told, Some(Told { file: "m3".to_owned(), line: 12, column: 5 }));
        assert_eq!(rendered("error: nowhere", "┌─ "), None);
        assert_eq!(plain("\u{1b}[1m\u{1b}[94m--> \u{1b}[0mm3:1:2"), "--> m3:1:2");
    }

    #[test]
    fn a_column_counts_only_in_the_right_file_and_line() {
        let fault =
            Fault { module: 3, text: String::new(), right: vec![Place { line: 2, first: 4, last: 6 }] };
        let told = |file: &str, line, column| Told { file: file.to_owned(), line, column };
        let mut score = Score::default();
        for told in [told("m3", 2, 6), told("m3", 2, 7), told("m3", 3, 4), told("m4", 2, 4)] {
            score.add(&fault, Some(&told));
        }
        score.add(&fault, None);
        assert_eq!(score, Score { faults: 5, noticed: 4, file: 3, line: 2, column: 1 });
    }
}
