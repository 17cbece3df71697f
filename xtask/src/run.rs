//! Running commands: each is shown before it runs, and a failure says what failed and how.

use std::ffi::{OsStr, OsString};
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Why a chore stopped.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command could not even be started.
    Start { command: String, cause: io::Error },
    /// The command ran and was not content. `said`: what it printed, where that was captured.
    Exit { command: String, status: ExitStatus, said: String },
    /// A file or folder could not be read or written.
    File { path: PathBuf, cause: io::Error },
    /// Something is not on this machine, and how to get it.
    Missing { what: String, remedy: String },
    /// A check of our own does not hold.
    Check(String),
}

/// What a step comes to.
pub(crate) type Outcome<T = ()> = Result<T, Failure>;

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start { command, cause } => write!(f, "`{command}` did not start: {cause}"),
            Self::Exit { command, status, said } => {
                write!(f, "`{command}` failed ({status})")?;
                if said.trim().is_empty() { Ok(()) } else { write!(f, ":\n{}", said.trim_end()) }
            }
            Self::File { path, cause } => write!(f, "{}: {cause}", path.display()),
            Self::Missing { what, remedy } => write!(f, "{what} is missing; {remedy}"),
            Self::Check(what) => f.write_str(what),
        }
    }
}

/// The repository's root.
pub(crate) fn root() -> &'static Path {
    let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask)
}

/// Cargo's target folder: `xtask` itself lies in its `debug/`, wherever cargo was told to put it.
pub(crate) fn target() -> Outcome<PathBuf> {
    let xtask = std::env::current_exe().map_err(|cause| Failure::File { path: "xtask".into(), cause })?;
    let target = xtask.parent().and_then(Path::parent);
    target
        .map(Path::to_owned)
        .ok_or_else(|| Failure::Check(format!("{} is no cargo target folder", xtask.display())))
}

/// `program` with `arguments`, run in the repository's root.
pub(crate) fn command(program: impl AsRef<OsStr>, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root());
    command
}

/// `cargo` with `line`'s arguments: the cargo that runs this chore.
pub(crate) fn cargo(line: &str) -> Command {
    let arguments: Vec<&str> = line.split_whitespace().collect();
    command(cargo_path(), &arguments)
}

fn cargo_path() -> OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// The `orogen` that `cargo build --release` makes.
pub(crate) fn orogen(arguments: &[&str]) -> Outcome<Command> {
    built("release", "orogen", arguments)
}

/// The `orogen` that `cargo build` makes, as the tests have it: slower, and there without another build.
pub(crate) fn tested_orogen(arguments: &[&str]) -> Outcome<Command> {
    built("debug", "orogen", arguments)
}

/// The program that cargo has put into `profile`'s folder as `name`.
pub(crate) fn built(profile: &str, name: &str, arguments: &[&str]) -> Outcome<Command> {
    let binary = target()?.join(profile).join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    Ok(command(binary, arguments))
}

/// What `work` makes of each of `items`, in their order; as many at a time as there are cores.
pub(crate) fn in_parallel<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let take = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else { return done };
            done.push((index, work(item)));
        }
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let mut done: Vec<(usize, R)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|_| scope.spawn(take)).collect();
        let joined = workers.into_iter().map(|worker| worker.join());
        joined.flat_map(|part| part.unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    });
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Shows `command`, then runs it with its output going where ours goes.
pub(crate) fn run(command: &mut Command) -> Outcome {
    println!("$ {}", shown(command));
    let status = command.status().map_err(|cause| Failure::Start { command: shown(command), cause })?;
    check(command, status, String::new())
}

/// Runs `command` without a word and returns what it wrote to standard output.
pub(crate) fn capture(command: &mut Command) -> Outcome<String> {
    let output = output(command)?;
    let stdout = String::from_utf8_lossy(&output.stdout).into_owned();
    // Some tools complain on standard output.
    let said = String::from_utf8_lossy(&output.stderr).into_owned() + &stdout;
    check(command, output.status, said)?;
    Ok(stdout)
}

/// Runs `command` without a word and returns everything about it, also where it fails.
pub(crate) fn output(command: &mut Command) -> Outcome<Output> {
    command.stdin(Stdio::null()).output().map_err(|cause| Failure::Start { command: shown(command), cause })
}

/// Turns a bad exit status into a failure.
pub(crate) fn check(command: &Command, status: ExitStatus, said: String) -> Outcome {
    if status.success() { Ok(()) } else { Err(Failure::Exit { command: shown(command), status, said }) }
}

/// `command` as one would type it in the repository's root, its variables first.
pub(crate) fn shown(command: &Command) -> String {
    let variables = command.get_envs().filter_map(|(name, value)| Some((name, value?)));
    let mut words: Vec<String> =
        variables.map(|(name, value)| format!("{}={}", name.display(), quoted(value))).collect();
    // `cargo` is known by its absolute path, but nobody types that.
    let program =
        if command.get_program() == cargo_path() { OsStr::new("cargo") } else { command.get_program() };
    words.push(quoted(program));
    words.extend(command.get_args().map(quoted));
    let line = words.join(" ");
    match command.get_current_dir() {
        Some(folder) if folder != root() => format!("cd {} && {line}", relative(folder.as_os_str())),
        _ => line,
    }
}

/// `word` relative to the root where it lies in there, in quotes where a shell would need them.
fn quoted(word: &OsStr) -> String {
    let word = relative(word);
    let plain = |c: char| c.is_alphanumeric() || "_-./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

fn relative(path: &OsStr) -> String {
    let path = Path::new(path);
    path.strip_prefix(root()).unwrap_or(path).display().to_string()
}

/// Creates `folder` and those above it.
pub(crate) fn create_folder(folder: &Path) -> Outcome {
    std::fs::create_dir_all(folder).map_err(|cause| Failure::File { path: folder.to_owned(), cause })
}

/// The text of the file at `path`.
pub(crate) fn read(path: &Path) -> Outcome<String> {
    std::fs::read_to_string(path).map_err(|cause| Failure::File { path: path.to_owned(), cause })
}

/// Writes `text` to the file at `path`.
pub(crate) fn write(path: &Path, text: &str) -> Outcome {
    std::fs::write(path, text).map_err(|cause| Failure::File { path: path.to_owned(), cause })
}

/// The steps of a chore: each announced and timed, all summed up at the end.
#[derive(Default)]
pub(crate) struct Steps {
    done: Vec<(&'static str, Duration, bool)>,
}

impl Steps {
    /// Announces the step, does its work and notes how it went.
    pub(crate) fn step(&mut self, name: &'static str, work: impl FnOnce() -> Outcome) -> Outcome {
        println!("\n── {name}");
        let start = Instant::now();
        let outcome = work();
        self.done.push((name, start.elapsed(), outcome.is_ok()));
        outcome
    }

    /// Prints how each step went and how long it took.
    pub(crate) fn sum_up(&self) {
        println!("\n── summary");
        for (name, time, passed) in &self.done {
            println!("{:>8.1} s  {}  {name}", time.as_secs_f64(), if *passed { "passed" } else { "FAILED" });
        }
        let total: Duration = self.done.iter().map(|(_, time, _)| *time).sum();
        println!("{:>8.1} s  in all", total.as_secs_f64());
        let passed = self.done.iter().filter(|(.., passed)| *passed).count();
        println!("steps: {passed} passed, {} failed", self.done.len() - passed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_done_in_parallel_comes_back_in_order() {
        let numbers: Vec<u64> = (0..100).collect();
        let late_first = |&number: &u64| {
            std::thread::sleep(Duration::from_micros(100 - number));
            number * number
        };
        let squares: Vec<u64> = numbers.iter().map(|number| number * number).collect();
        assert_eq!(in_parallel(&numbers, late_first), squares);
    }

    #[test]
    fn a_command_is_shown_as_one_would_type_it() {
        let mut export =
            command(root().join("target/release/orogen"), &["export", "alpine", "--live", "*", "-o"]);
        export.arg(root().join("out/alpine.wgsl")).env("VK_DRIVER_FILES", "/a b.json");
        let expected =
            "VK_DRIVER_FILES='/a b.json' target/release/orogen export alpine --live '*' -o out/alpine.wgsl";
        assert_eq!(shown(&export), expected);
        assert_eq!(shown(&cargo("build --release")), "cargo build --release");
    }

    #[test]
    fn a_command_run_elsewhere_says_where() {
        let mut install = command("npm", &["ci"]);
        install.current_dir(root().join("tests/judges"));
        assert_eq!(shown(&install), "cd tests/judges && npm ci");
    }

    #[test]
    fn the_first_failure_keeps_its_words() {
        let missing = capture(&mut command("orogen-has-no-such-program", &[])).expect_err("it is not there");
        assert!(missing.to_string().starts_with("`orogen-has-no-such-program` did not start"), "{missing}");
    }
}
