//! `orogen eval`

use std::io::Read;
use std::path::Path;

use orogen::Preset;
use orogen::render::Gpu;
use orogen::render::sample::{self, Column, Points, Query};

use super::args::{Common, Eval};
use super::failure::{Failure, Outcome};
use super::{input, output, progress};

pub(super) fn run(args: &Eval, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let preset = match &args.preset {
        Some(name) => Some(input::preset(name, common)?),
        None if common.set.is_empty() => None,
        None => {
            let mut preset = Preset::of_text("--set", "");
            for assignment in &common.set {
                preset.set(assignment)?;
            }
            Some(preset)
        }
    };
    let points = match &args.points {
        None => Points::default(),
        Some(path) => read(path)?,
    };
    let templates = input::composer(common)?.templates;
    let query = Query {
        expression: &args.expression,
        includes: &args.include,
        preset: preset.as_ref(),
        points: &points,
    };
    let gpu = Gpu::new(args.adapter.as_deref())?;
    let spinner = progress::bar("evaluating", common.quiet);
    let table = sample::evaluate(&gpu, &library, &templates, &query)?;
    spinner.finish_and_clear();
    let mut text = Vec::new();
    let mut writer = csv::Writer::from_writer(&mut text);
    let mut write = || -> csv::Result<()> {
        writer.write_record(&table.columns)?;
        for row in table.rows() {
            writer.write_record(row.iter().map(ToString::to_string))?;
        }
        Ok(writer.flush()?)
    };
    write().map_err(|error| Failure::System(error.to_string()))?;
    drop(writer);
    output::print(&text)
}

/// The points of a CSV; a fault in it is told with its line.
fn read(path: &Path) -> Result<Points, Failure> {
    let shown = if path == Path::new("-") { "standard input".into() } else { path.display().to_string() };
    let fault = |why: String| Failure::System(format!("`{shown}`: {why}"));
    let reader: Box<dyn Read> = if path == Path::new("-") {
        Box::new(std::io::stdin().lock())
    } else {
        Box::new(std::fs::File::open(path).map_err(|error| fault(error.to_string()))?)
    };
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).flexible(true).from_reader(reader);
    let header = reader.headers().map_err(|error| fault(error.to_string()))?.clone();
    if header.is_empty() {
        return Err(fault("there is no header that names the columns, as in `x,y,seed:u32`".into()));
    }
    let columns = header.iter().map(Column::parse).collect::<Result<Vec<_>, orogen::Error>>()?;
    let mut points = Points { columns, values: Vec::new() };
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(|error| fault(error.to_string()))? {
        let line = record.position().map_or(0, csv::Position::line);
        let (found, expected) = (record.len(), points.columns.len());
        if found != expected {
            return Err(fault(format!("line {line} has {found} values where the header has {expected}")));
        }
        for (column, text) in points.columns.iter().zip(&record) {
            let value = column.kind.parse(text).ok_or_else(|| {
                let (name, kind) = (&column.name, column.kind.name());
                fault(format!("line {line}: `{text}` is not of type {kind}, which column `{name}` is"))
            })?;
            points.values.push(value);
        }
    }
    Ok(points)
}
