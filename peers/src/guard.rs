//! `--quick`: a few ratios held against those that were committed, so that what makes Orogen slower beside the others does not
//! come in unseen.
//!
//! All values are better the smaller they are. Busy machines make rows worse by chance: a row that fails is measured again, up to
//! five times, and only what never comes below its bound fails.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::Outcome;
use crate::child::{self, End};
use crate::contest::{Entrant, Work, number, output};
use crate::faults;
use crate::graph::{Plan, Shape};
use crate::time::{interleaved, quartiles};
use crate::tool::Tool;

/// By how much a row may be worse than its baseline.
const WORSE: f64 = 1.2;
const REPEATS: usize = 5;

/// One number: what it is called, and how it is measured.
struct Row {
    name: String,
    measure: Box<dyn Fn() -> Outcome<f64>>,
}

/// Holds all rows against the file at `path`, or writes it. Fails where a row is worse than it may be.
pub(crate) fn guard(path: &Path, accept: bool) -> Outcome {
    let start = Instant::now();
    let known: BTreeMap<String, f64> = match std::fs::read_to_string(path) {
        Ok(text) => serde_json::from_str(&text)?,
        Err(_) if accept => BTreeMap::new(),
        Err(why) => return Err(format!("{}: {why}; `--accept` writes it", path.display()).into()),
    };
    let mut measured = BTreeMap::new();
    let mut failed = Vec::new();
    println!("{:<64}{:>10}{:>10}", "ours / theirs (less is better)", "now", "baseline");
    for row in rows() {
        let mut value = if accept { steady(&row)? } else { (row.measure)()? };
        let baseline = known.get(&row.name).copied();
        let bound = baseline.map_or(f64::INFINITY, |baseline| baseline * WORSE);
        let mut again = 0;
        while !accept && value > bound && again < REPEATS {
            again += 1;
            value = value.min((row.measure)()?);
        }
        let verdict = match baseline {
            _ if accept => "",
            None => "  has no baseline",
            Some(_) if value > bound => "  WORSE",
            Some(_) if again > 0 => "  repeated",
            Some(_) => "",
        };
        let told = baseline.map_or("–".to_owned(), number);
        println!("{:<64}{:>10}{told:>10}{verdict}", row.name, number(value));
        if !accept && (baseline.is_none() || value > bound) {
            failed.push(row.name.clone());
        }
        measured.insert(row.name, value);
    }
    for gone in known.keys().filter(|name| !accept && !measured.contains_key(*name)) {
        failed.push(format!("{gone} (in the baseline, and measured no more)"));
    }
    println!("\n{} rows in {:.0} s", measured.len(), start.elapsed().as_secs_f64());
    if accept {
        std::fs::write(path, serde_json::to_string_pretty(&measured)? + "\n")?;
        println!("{} is written", path.display());
        return Ok(());
    }
    match failed.as_slice() {
        [] => Ok(()),
        names => Err(format!("worse than the baseline by more than a fifth: {}", names.join("; ")).into()),
    }
}

/// The median of several measurements: what a baseline is made of.
fn steady(row: &Row) -> Outcome<f64> {
    let values = (0..3).map(|_| (row.measure)()).collect::<Outcome<Vec<f64>>>()?;
    Ok(quartiles(values.into_iter()).median)
}

fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    let plan = |shape, modules, functions| Plan { shape, modules, functions };
    for plan in [plan(Shape::Wide, 100, 20), plan(Shape::Diamond, 32, 16), plan(Shape::Chain, 32, 16)] {
        for (work, words) in
            [(Work::Cold, "cold"), (Work::New, "new definitions"), (Work::Leaf, "one leaf edited")]
        {
            for other in [Tool::NagaOilLean, Tool::Wesl] {
                let name = format!("{words}, {} / {}", plan.name(), other.name());
                rows.push(Row { name, measure: Box::new(move || time(plan, work, other)) });
            }
        }
        for other in [Tool::NagaOilLean, Tool::Wesl] {
            let name = format!("peak memory, {} / {}", plan.name(), other.name());
            rows.push(Row { name, measure: Box::new(move || memory(plan, other)) });
        }
        let name = format!("output, {} / {}", plan.name(), Tool::Wesl.name());
        let size = move || Ok(output(Tool::Orogen, plan)?[0] as f64 / output(Tool::Wesl, plan)?[0] as f64);
        rows.push(Row { name, measure: Box::new(size) });
    }
    // In percent of faults told wrong, and one, so that there is something to take a fifth of.
    let wrong = || {
        let totals = faults::totals(&faults::scores(4)?);
        Ok(1.0 + 100.0 - totals[0].least())
    };
    rows.push(Row {
        name: "1 + percent of faults told at a wrong place".to_owned(),
        measure: Box::new(wrong),
    });
    rows
}

/// Our CPU time over another's.
fn time(plan: Plan, work: Work, other: Tool) -> Outcome<f64> {
    let entrants = [Tool::Orogen, other].map(|tool| Entrant::new(tool, plan));
    let mut turns = entrants.iter().map(|entrant| entrant.turn(work)).collect::<Outcome<Vec<_>>>()?;
    let runs = interleaved(&mut turns, (3, 9), Duration::from_secs(2))?;
    let [ours, theirs] = runs.as_slice() else { return Err("two contestants, and not two times".into()) };
    Ok(ours.cpu().median / theirs.cpu().median)
}

/// Our peak of memory over another's.
fn memory(plan: Plan, other: Tool) -> Outcome<f64> {
    let peak = |tool| match child::run(Some(tool), plan, tool, Duration::from_secs(60))? {
        End::Done(peak) => Ok::<f64, Box<dyn std::error::Error>>(peak.kib),
        End::TooLong => Err("it did not end".into()),
        End::Failed(words) => Err(words.into()),
    };
    Ok(peak(Tool::Orogen)? / peak(other)?)
}
