//! Part 1: composing, beside `naga_oil` and `wesl`. The same graphs in every dialect, from sources in memory to a module that
//! naga has validated.

use std::time::Duration;

use orogen::export::minify;
use orogen::{Bake, Library, Preset, Templates, compose};

use super::gate;
use super::gpu::Lab;
use crate::Outcome;
use crate::child::{self, End};
use crate::contest::{Entrant, Work, gzipped, number, output};
use crate::graph::{Plan, Shape};
use crate::page::{Section, table};
use crate::time::{Quartiles, Runs, interleaved};
use crate::tool::Tool;

pub(crate) const TITLE: &str = "Composing";

const SIZES: [(usize, usize); 4] = [(8, 8), (32, 16), (100, 20), (400, 20)];
/// Of these sizes the bars are held.
const JUDGED: [(usize, usize); 2] = [(100, 20), (400, 20)];
/// A contestant that needs longer for one composition is out.
const MOST: Duration = Duration::from_secs(30);
const ROUNDS: usize = 15;
const BUDGET: Duration = Duration::from_secs(12);
/// The one shader that has so many.
const OF_PRESETS: Plan = Plan { shape: Shape::Diamond, modules: 32, functions: 16 };

/// A contestant's times at one graph; none where it is out.
struct Row {
    plan: Plan,
    work: Work,
    runs: Vec<Option<Runs>>,
}

/// The contestants' sizes and memory at one graph.
struct Weight {
    plan: Plan,
    /// KiB over what the sources alone take, and in all.
    memory: Vec<Option<(f64, f64)>>,
    /// Bytes raw, gzipped, and minified by whoever can.
    output: Vec<Option<[usize; 2]>>,
}

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let mut rows = Vec::new();
    let mut weights = Vec::new();
    let mut outs = Vec::new();
    let mut compared = 0;
    for (modules, functions) in SIZES {
        for shape in Shape::ALL {
            let plan = Plan { shape, modules, functions };
            eprintln!("composing: {}", plan.name());
            let mut weight = Weight { plan, memory: Vec::new(), output: Vec::new() };
            let mut tools = Vec::new();
            for tool in Tool::ALL {
                let alone = child::run(None, plan, tool, MOST)?;
                let (End::Done(alone), end) = (alone, child::run(Some(tool), plan, tool, MOST)?) else {
                    return Err("the sources alone could not be made".into());
                };
                weight.memory.push(match end {
                    End::Done(peak) => {
                        tools.push(tool);
                        Some((peak.kib - alone.kib, peak.kib))
                    }
                    End::TooLong => {
                        outs.push((plan, tool, format!("did not end within {} s", MOST.as_secs())));
                        None
                    }
                    End::Failed(words) => {
                        outs.push((plan, tool, words));
                        None
                    }
                });
            }
            compared += usize::from(gate::hold(lab, plan, &tools)?);
            for tool in Tool::ALL {
                let sizes = tools.contains(&tool).then(|| output(tool, plan)).transpose()?;
                weight.output.push(sizes);
            }
            weights.push(weight);
            for work in Work::ALL {
                if work == Work::Presets && plan != OF_PRESETS {
                    continue; // sixty-four of a larger one would take minutes a run, and say nothing else
                }
                let row = row(plan, work, &tools)?;
                rows.push(row);
            }
        }
    }
    Ok(Section { title: TITLE, text: text(&rows, &weights, &outs, compared)? })
}

fn row(plan: Plan, work: Work, tools: &[Tool]) -> Outcome<Row> {
    let entrants: Vec<Entrant> = tools.iter().map(|tool| Entrant::new(*tool, plan)).collect();
    let mut turns = entrants.iter().map(|entrant| entrant.turn(work)).collect::<Outcome<Vec<_>>>()?;
    let least = if work == Work::Presets { 1 } else { 3 };
    let mut measured = interleaved(&mut turns, (least, ROUNDS), BUDGET)?.into_iter();
    let runs = Tool::ALL.map(|tool| if tools.contains(&tool) { measured.next() } else { None });
    let row = Row { plan, work, runs: runs.into() };
    let told = Tool::ALL.iter().zip(&row.runs).map(|(tool, runs)| {
        format!("{} {}", tool.name(), runs.as_ref().map_or("–".to_owned(), |runs| number(runs.cpu().median)))
    });
    eprintln!("  {:<40}{}", work.name(), told.collect::<Vec<_>>().join("   "));
    Ok(row)
}

/// Bytes raw and gzipped: as composed, minified by us, minified by `wgsl-minifier`.
struct Minified {
    name: String,
    sizes: [Result<[usize; 2], String>; 3],
}

fn minified(name: &str, preset: &Preset) -> Outcome<Minified> {
    let shader = compose(&Library::standard(), preset, &Bake::constants())?;
    let ours = minify(&shader, &Templates::standard())?;
    let sizes = |text: &str| Ok::<_, Box<dyn std::error::Error>>([text.len(), gzipped(text)?]);
    let theirs = theirs(shader.wgsl()).map(|text| sizes(&text));
    let theirs = match theirs {
        Ok(sizes) => Ok(sizes?),
        Err(why) => Err(why),
    };
    let sizes = [Ok(sizes(shader.wgsl())?), Ok(sizes(ours.shader().wgsl())?), theirs];
    Ok(Minified { name: name.to_owned(), sizes })
}

/// `wgsl-minifier`'s output, made as its own program makes it; or why there is none.
fn theirs(wgsl: &str) -> Result<String, String> {
    let minify = || {
        let mut module = naga24::front::wgsl::parse_str(wgsl).map_err(|error| error.message().to_owned())?;
        wgsl_minifier::minify_module(&mut module);
        let mut validator = naga24::valid::Validator::new(
            naga24::valid::ValidationFlags::all(),
            naga24::valid::Capabilities::all(),
        );
        let info = validator.validate(&module).map_err(|error| error.into_inner().to_string())?;
        let flags = naga24::back::wgsl::WriterFlags::empty();
        let text =
            naga24::back::wgsl::write_string(&module, &info, flags).map_err(|error| error.to_string())?;
        Ok(wgsl_minifier::minify_wgsl_source(&text))
    };
    std::panic::catch_unwind(minify).unwrap_or_else(|_| Err("it panicked".to_owned()))
}

fn text(rows: &[Row], weights: &[Weight], outs: &[(Plan, Tool, String)], compared: usize) -> Outcome<String> {
    let names = Tool::ALL.map(Tool::name);
    let mut text = format!(
        "The same module graphs, written by one generator in three dialects, from sources in memory to one module that naga has \
         parsed and validated. Each tool takes the texts as it can without copying them where it can. A graph of 100×20 is 100 modules of 20 functions. `naga_oil` runs twice: as `Composer::default()`, \
         which can say where an error is, and as `Composer::non_validating()`, which cannot (its module is validated once at the \
         end, as all are). `wesl` runs without its own validation and without its source map. Orogen always keeps its map.\n\n\
         Before anything was timed, all contestants validated at every graph and offered the same interface under two sets of \
         values; at the {compared} graphs of up to 64 functions they computed the same 4096 values, bit for bit.\n"
    );
    if !outs.is_empty() {
        text += "\nOut:\n\n";
        for (plan, tool, why) in outs {
            text += &format!("- {} at {}: {why}\n", tool.name(), plan.name());
        }
    }
    for work in Work::ALL {
        text += &format!("\n### {}\n\n{}\n", work.name(), explained(work));
        let of_work: Vec<&Row> = rows.iter().filter(|row| row.work == work).collect();
        let lines: Vec<[String; 7]> = of_work.iter().map(|row| line(row, rows)).collect();
        let head = ["graph", names[0], names[1], names[2], names[3], "best of the others / ours", "bar"];
        text += &table(head, &lines);
    }
    text += "\n### Peak memory\n\nMiB of a process that makes the sources and composes them once; in brackets without what the sources alone take. Bar: below both.\n\n";
    let lines: Vec<[String; 6]> = weights.iter().map(memory_line).collect();
    text += &table(["graph", names[0], names[1], names[2], names[3], "bar"], &lines);
    text += "\n### Size of the output\n\nKiB raw / gzipped. `naga_oil` makes a module; its text is what naga writes of it.\n\n";
    let lines: Vec<[String; 4]> = weights.iter().map(size_line).collect();
    text += &table(["graph", names[0], names[1], names[3]], &lines);
    text += "\nPresets of the library, minified: by `orogen export --minify`, and by the crate `wgsl-minifier`. KiB raw / gzipped.\n\n";
    let mut lines = Vec::new();
    for name in ["alpine", "cumulus", "earth", "lake"] {
        let minified = minified(name, &Preset::named(name)?)?;
        let [composed, ours, theirs] = minified.sizes.map(|sizes| sizes.map_or_else(|why| why, kib));
        lines.push([minified.name, composed, ours, theirs]);
    }
    text += &table(["preset", "composed", "orogen --minify", "wgsl-minifier"], &lines);
    text += WHY;
    Ok(text)
}

/// Where bars are missed, and what a profile says about it.
const WHY: &str = "
### What stands in the way

Profiles (callgrind and massif, of the graph wide 100×20 composed cold) say where Orogen's time and memory go: 82 % of the instructions \
are naga parsing the composed text, 9 % naga validating it, 8 % composing. A leaf edited costs \
what naga takes for the whole text: composing alone is then a few percent. `naga_oil` keeps naga's module of each file, so a link \
without anything new parses the root alone; it pays for that when anything is new, since whatever depends on the change is built \
again. Orogen hands one text to naga, which is what lets it keep the author's words; there is no way to hand naga a part of it.

Wide graphs have a root of one function with a call for every function there is: 8000 at 400×20. naga's time for one function grows \
with the square of its expressions: its `Typifier::grow` looks for those that are new by `Arena::iter().skip(n)`, which steps through \
all that it skips. By `perf` that is half of Orogen's time at wide 400×20 and a third of `naga_oil`'s, the same second for both (a \
quarter and a seventh at wide 100×20), and nothing in the diamond, whose root has 160 calls. Without it the rest is more than twice as \
fast as theirs; no text that Orogen could write in the author's words avoids it.

Memory peaks while naga parses, and nine tenths of the peak are naga's tree and module, the same for whoever hands it one text. What \
Orogen adds is its text with comments, where each name stands, and, while it may compose again, what it knows of each file. Tokens go \
once a file is split, and what is only for the next composition goes before naga comes where there is no next one: both are mends \
that this suite brought.
";

fn explained(work: Work) -> &'static str {
    match work {
        Work::Cold => "Nothing is known. Bar: twice as fast as each of the others.\n",
        Work::New => {
            "Composed before, and now under another set of definitions, on which a quarter of the modules depends.\n"
        }
        Work::Known => {
            "Two sets of definitions take turns, and both were composed before: what can be kept is there, and `naga_oil` has every \
             module built.\n"
        }
        Work::Leaf => {
            "A module that includes nothing gets another text, and everything is made again. Bar: as fast as the faster `naga_oil`'s \
             warm; told against a new set of definitions / against one seen before, where that edits nothing and links what it has.\n"
        }
        Work::Presets => {
            "64 sets of values that were not seen before, one after the other; the time of all of them.\n"
        }
    }
}

/// A row of a table of times.
fn line(row: &Row, all: &[Row]) -> [String; 7] {
    let cell = |runs: &Option<Runs>| runs.as_ref().map_or("–".to_owned(), cell);
    let ours = cpu(row, Tool::Orogen);
    let others = Tool::ALL[1..].iter().filter_map(|tool| cpu(row, *tool));
    let best = others.min_by(f64::total_cmp);
    let ratio = ours.zip(best).map(|(ours, best)| best / ours);
    let size = (row.plan.modules, row.plan.functions);
    let against = |work: Work| {
        let warm = all.iter().find(|other| other.plan == row.plan && other.work == work)?;
        let both = [cpu(warm, Tool::NagaOil), cpu(warm, Tool::NagaOilLean)];
        let theirs = both.into_iter().flatten().min_by(f64::total_cmp)?;
        Some(format!("{} ({:.2})", verdict(Some(ours? <= theirs)), theirs / ours?))
    };
    let holds = match row.work {
        _ if !JUDGED.contains(&size) => String::new(),
        Work::Cold => verdict(ratio.map(|ratio| ratio >= 2.0)),
        Work::Leaf => match (against(Work::New), against(Work::Known)) {
            (Some(new), Some(known)) => format!("{new} / {known}"),
            _ => String::new(),
        },
        Work::New | Work::Known | Work::Presets => String::new(),
    };
    [
        row.plan.name(),
        cell(&row.runs[0]),
        cell(&row.runs[1]),
        cell(&row.runs[2]),
        cell(&row.runs[3]),
        ratio.map_or("–".to_owned(), |ratio| format!("{ratio:.2}")),
        holds,
    ]
}

fn cpu(row: &Row, tool: Tool) -> Option<f64> {
    let index = Tool::ALL.iter().position(|one| *one == tool)?;
    row.runs[index].as_ref().map(|runs| runs.cpu().median)
}

/// `12.3 (12.1–12.6), 12.4 wall`
fn cell(runs: &Runs) -> String {
    let Quartiles { low, median, high } = runs.cpu();
    format!("{} ({}–{}), {} wall", number(median), number(low), number(high), number(runs.wall().median))
}

fn memory_line(weight: &Weight) -> [String; 6] {
    let mib = |kib: f64| format!("{:.1}", kib / 1024.0);
    let cell = |index: usize| {
        weight.memory[index].map_or("–".to_owned(), |(own, all)| format!("{} ({})", mib(all), mib(own)))
    };
    let others = weight.memory[1..].iter().flatten().map(|(_, all)| *all).min_by(f64::total_cmp);
    let judged = JUDGED.contains(&(weight.plan.modules, weight.plan.functions));
    let holds = weight.memory[0].zip(others).map(|((_, ours), theirs)| ours < theirs).filter(|_| judged);
    [weight.plan.name(), cell(0), cell(1), cell(2), cell(3), verdict(holds)]
}

fn size_line(weight: &Weight) -> [String; 4] {
    let cell = |index: usize| weight.output[index].map_or("–".to_owned(), kib);
    [weight.plan.name(), cell(0), cell(1), cell(3)]
}

fn kib([raw, gzipped]: [usize; 2]) -> String {
    format!("{:.1} / {:.1}", raw as f64 / 1024.0, gzipped as f64 / 1024.0)
}

fn verdict(holds: Option<bool>) -> String {
    match holds {
        None => String::new(),
        Some(true) => "kept".to_owned(),
        Some(false) => "**missed**".to_owned(),
    }
}
