//! `orogen check`

use super::args::{Check, Common, MessageFormat};
use super::failure::{Failure, Outcome};
use super::{input, output};

pub(super) fn run(args: &Check, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let mut composer = input::composer(common)?;
    let json = args.message_format == MessageFormat::Json;
    let mut wrong = 0;
    for name in &args.presets {
        let checked = input::preset(name, common).and_then(|preset| {
            composer.run(&library, &preset, &orogen::Bake::constants()).map_err(Failure::from)
        });
        match checked {
            Ok(_) => {}
            Err(Failure::Input(error)) => {
                wrong += 1;
                if json {
                    output::print(error.json_lines().as_bytes())?;
                } else {
                    output::complain(&error.render(super::colour()));
                }
            }
            Err(Failure::System(message)) => {
                wrong += 1;
                output::complain(&format!("error: {message}\n"));
            }
            Err(other) => return Err(other),
        }
    }
    if !common.quiet && !json {
        output::complain(&format!("{}\n", summary(args.presets.len(), wrong)));
    }
    if wrong == 0 { Ok(()) } else { Err(Failure::Reported) }
}

fn summary(all: usize, wrong: usize) -> String {
    match (all, wrong) {
        (_, 0) => format!("{all} checked, no errors"),
        (1, _) => "1 checked, it has errors".into(),
        _ => format!("{all} checked, {wrong} with errors"),
    }
}
