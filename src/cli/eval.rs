//! `orogen eval`

use std::io::{self, Read};
use std::path::Path;

use orogen::Preset;
use orogen::render::Gpu;
use orogen::render::sample::{self, Column, Points, Query};

use super::args::{Common, Eval};
use super::failure::{Failure, Outcome};
use super::{include, input, output, progress};

pub(super) fn run(args: &Eval, common: &Common) -> Outcome {
    let (library, includes) = include::on_disk(input::library(common)?, &args.include)?;
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
    let query =
        Query { expression: &args.expression, includes: &includes, preset: preset.as_ref(), points: &points };
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

/// The most that is read of a CSV.
const MOST_BYTES: u64 = 1 << 30;

/// A reader that gives no more than so many bytes.
struct Bounded<R> {
    reader: R,
    left: u64,
}

impl<R: Read> Read for Bounded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.reader.read(buffer)?;
        let left = self.left.checked_sub(count as u64);
        self.left =
            left.ok_or_else(|| io::Error::other("there is more of it than 1 GiB: give it in parts"))?;
        Ok(count)
    }
}

/// What the CSV reader has to say, in plain words.
fn plain(error: &csv::Error) -> String {
    match error.kind() {
        csv::ErrorKind::Io(why) => why.to_string(),
        csv::ErrorKind::Utf8 { pos, .. } => match pos {
            Some(pos) => format!("line {} is not UTF-8 text", pos.line()),
            None => "it is not UTF-8 text".into(),
        },
        _ => error.to_string(),
    }
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
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .flexible(true)
        .from_reader(Bounded { reader, left: MOST_BYTES });
    let header = reader.headers().map_err(|error| fault(plain(&error)))?.clone();
    if header.is_empty() {
        return Err(fault("there is no header that names the columns, as in `x,y,seed:u32`".into()));
    }
    let columns = header.iter().map(Column::parse).collect::<Result<Vec<_>, orogen::Error>>()?;
    let mut points = Points { columns, values: Vec::new() };
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(|error| fault(plain(&error)))? {
        let line = record.position().map_or(0, csv::Position::line);
        let (found, expected) = (record.len(), points.columns.len());
        if found != expected {
            return Err(fault(format!("line {line} has {found} values where the header has {expected}")));
        }
        for (column, text) in points.columns.iter().zip(&record) {
            let value = column.kind.parse(text).ok_or_else(|| {
                let (name, refusal) = (&column.name, column.kind.refusal(text));
                fault(format!("line {line}: `{text}` {refusal}, which column `{name}` is"))
            })?;
            points.values.push(value);
        }
    }
    Ok(points)
}
