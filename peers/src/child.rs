//! One contestant in a process of its own: for its peak of memory, and so that one that does not end can be ended.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::Outcome;
use crate::graph::{Plan, Settings, Shape};
use crate::tool::{Session, Tool};

/// What a child tells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Peak {
    /// The most memory (KiB) that it had, the sources included.
    pub(crate) kib: f64,
}

/// How a child went.
pub(crate) enum End {
    Done(Peak),
    /// It ran longer than it may.
    TooLong,
    /// Its last words.
    Failed(String),
}

/// Composes `plan` once with `tool`, or with none only makes the sources, in a process of its own.
pub(crate) fn run(tool: Option<Tool>, plan: Plan, dialect_of: Tool, most: Duration) -> Outcome<End> {
    let tool_name = tool.map_or("none", Tool::name);
    let sizes = [plan.modules.to_string(), plan.functions.to_string()];
    let mut child = Command::new(std::env::current_exe()?)
        .args(["child", tool_name, dialect_of.name(), plan.shape.name()])
        .args(sizes)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let start = Instant::now();
    while child.try_wait()?.is_none() {
        if start.elapsed() > most {
            child.kill()?;
            child.wait()?;
            return Ok(End::TooLong);
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let output = child.wait_with_output()?;
    let said = String::from_utf8_lossy(&output.stdout);
    match said.trim().parse() {
        Ok(kib) if output.status.success() => Ok(End::Done(Peak { kib })),
        _ => {
            let complaint = String::from_utf8_lossy(&output.stderr);
            let last = complaint.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("no word");
            Ok(End::Failed(last.to_owned()))
        }
    }
}

/// What the child does: `none|TOOL TOOL SHAPE MODULES FUNCTIONS` → its peak of memory, printed.
pub(crate) fn be(arguments: &[String]) -> Outcome {
    let [tool, dialect_of, shape, modules, functions] = arguments else {
        return Err("a child takes five arguments".into());
    };
    let shape = Shape::named(shape).ok_or("there is no such shape")?;
    let plan = Plan { shape, modules: modules.parse()?, functions: functions.parse()? };
    let dialect = Tool::named(dialect_of).ok_or("there is no such tool")?.dialect();
    let graph = plan.graph(dialect);
    if let Some(tool) = Tool::named(tool) {
        let session = Session::open(tool, &graph)?;
        std::hint::black_box(&session.compose_once(Settings::default())?);
    }
    std::hint::black_box(&graph);
    println!("{}", peak()?);
    Ok(())
}

/// The most memory (KiB) that this process had so far.
fn peak() -> Outcome<f64> {
    let status = std::fs::read_to_string("/proc/self/status")?; // Linux; elsewhere the bench stops here and says so
    let line =
        status.lines().find_map(|line| line.strip_prefix("VmHWM:")).ok_or("no peak in /proc/self/status")?;
    Ok(line.trim().trim_end_matches("kB").trim().parse()?)
}
