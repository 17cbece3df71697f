//! What is timed when the contestants compose, and what comes out: a contestant and a graph → its turn.

use std::io::Write as _;

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::Outcome;
use crate::graph::{Graph, Plan, Settings};
use crate::time::{Turn, timed};
use crate::tool::{Session, Tool};

const PRESETS: usize = 64;

/// What is timed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Nothing is known yet.
    Cold,
    /// Everything was composed once; another set of definitions, which is new.
    New,
    /// Two sets of definitions take turns, both known.
    Known,
    /// One module that includes nothing has another text.
    Leaf,
    /// Sixty-four sets of values, one after the other, none seen before.
    Presets,
}

impl Work {
    pub(crate) const ALL: [Self; 5] = [Self::Cold, Self::New, Self::Known, Self::Leaf, Self::Presets];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Cold => "Cold",
            Self::New => "Warm, a new set of definitions",
            Self::Known => "Warm, a set of definitions seen before",
            Self::Leaf => "One leaf edited",
            Self::Presets => "64 presets of one shader",
        }
    }
}

/// One graph in the words of one contestant, and two versions of its leaf.
pub(crate) struct Entrant {
    pub(crate) tool: Tool,
    graph: Graph,
    leaf: String,
    versions: [String; 2],
}

impl Entrant {
    pub(crate) fn new(tool: Tool, plan: Plan) -> Self {
        let dialect = tool.dialect();
        let versions = [1, 2].map(|salt| plan.module(dialect, plan.leaf(), salt));
        Self { tool, graph: plan.graph(dialect), leaf: format!("m{}", plan.leaf()), versions }
    }

    /// What the contestant does in its turn.
    pub(crate) fn turn(&self, work: Work) -> Outcome<Turn<'_>> {
        let open = || Session::open(self.tool, &self.graph);
        Ok(match work {
            Work::Cold => Box::new(move |_| {
                timed(|| {
                    let mut session = open()?;
                    let composed = session.compose(Settings::default())?;
                    Ok((session, composed))
                })
            }),
            Work::New => Box::new(move |_| {
                let mut session = open()?;
                session.compose(Settings::default())?;
                timed(|| {
                    let composed = session.compose(Settings { fine: false, ..Settings::default() })?;
                    Ok((session, composed))
                })
            }),
            Work::Known => {
                let mut session = open()?;
                for fine in [true, false] {
                    session.compose(Settings { fine, ..Settings::default() })?;
                }
                Box::new(move |round| {
                    timed(|| session.compose(Settings { fine: round % 2 == 0, ..Settings::default() }))
                })
            }
            Work::Leaf => {
                let mut session = open()?;
                session.compose(Settings::default())?;
                Box::new(move |round| {
                    timed(|| {
                        session.edit(&self.leaf, &self.versions[round % 2])?;
                        session.compose(Settings::default())
                    })
                })
            }
            Work::Presets => Box::new(move |_| {
                let mut session = open()?;
                session.compose(Settings::default())?;
                timed(|| {
                    for preset in 0..PRESETS {
                        session.compose(Settings { fine: preset % 2 == 0, gain: preset as i32 })?;
                    }
                    Ok(session)
                })
            }),
        })
    }
}

/// The bytes of what a contestant makes: raw, and gzipped.
pub(crate) fn output(tool: Tool, plan: Plan) -> Outcome<[usize; 2]> {
    let graph = plan.graph(tool.dialect());
    let composed = Session::open(tool, &graph)?.compose(Settings::default())?;
    let text = composed.wgsl()?;
    Ok([text.len(), gzipped(&text)?])
}

pub(crate) fn gzipped(text: &str) -> Outcome<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes())?;
    Ok(encoder.finish()?.len())
}

/// Three digits that count.
pub(crate) fn number(value: f64) -> String {
    match value.abs() {
        big if big >= 100.0 => format!("{value:.0}"),
        middle if middle >= 10.0 => format!("{value:.1}"),
        small if small >= 1.0 => format!("{value:.2}"),
        _ => format!("{value:.3}"),
    }
}
