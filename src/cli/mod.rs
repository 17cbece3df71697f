//! Arguments, progress, exit codes. What the commands do, the library does.

mod args;
mod check;
mod eval;
mod export;
mod failure;
mod heightmap;
mod include;
mod input;
mod list;
mod made_of;
mod output;
mod package;
mod params;
mod progress;
mod render;

use std::io::IsTerminal;
use std::process::ExitCode;

use clap::Parser;

use args::{Arguments, Command};
use failure::Failure;

/// Runs the command that the process was started with. Exit status: 0 done, 1 the input is wrong, 2 usage, 3 no adapter.
pub(crate) fn run() -> ExitCode {
    quiet_guarded_panics();
    let Arguments { mut common, command } = Arguments::parse(); // on a usage error: says so, and exits with 2
    if let Some(quality) = &common.quality {
        common.set.insert(0, format!("quality={quality}")); // an option like any other; what is set explicitly comes later
    }
    let outcome = match command {
        Command::Export(args) => export::run(&args, &common),
        Command::Check(args) => check::run(&args, &common),
        Command::Render(args) => render::run(&args, &common),
        Command::Params(args) => params::run(&args, &common),
        Command::List(args) => list::run(&args, &common),
        Command::Eval(args) => eval::run(&args, &common),
        Command::Heightmap(args) => heightmap::run(&args, &common),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => tell(failure),
    }
}

fn tell(failure: Failure) -> ExitCode {
    match failure {
        Failure::Reported => ExitCode::from(1),
        Failure::Usage(message) => {
            output::complain(&format!("error: {message}\n\nFor more information, try '--help'.\n"));
            ExitCode::from(2)
        }
        Failure::Input(error) => {
            output::complain(&error.render(colour()));
            ExitCode::from(if orogen::render::is_no_adapter(&error) { 3 } else { 1 })
        }
        Failure::System(message) => {
            output::complain(&format!("error: {message}\n"));
            ExitCode::from(1)
        }
    }
}

/// Whether standard error shows colours.
fn colour() -> bool {
    std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none()
}

/// A panic inside naga comes back as an error of ours: nothing to print about it.
fn quiet_guarded_panics() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        if !orogen::check::is_guarded() {
            usual(info);
        }
    }));
}
