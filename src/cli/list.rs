//! `orogen list`

use orogen::Preset;
use orogen::compose::{catalogue, views};
use orogen::source::preset_names;

use super::args::{Common, List, Listing};
use super::failure::Outcome;
use super::{input, output};

pub(super) fn run(args: &List, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let rows = match args.what {
        Listing::Presets => preset_names()
            .into_iter()
            .map(|name| Ok((name.to_owned(), Preset::named(name)?.about().to_owned())))
            .collect::<Result<Vec<_>, orogen::Error>>()?,
        Listing::Modules => catalogue(&library).modules,
        Listing::Scenes => catalogue(&library).scenes,
        Listing::Views => views(&library),
        Listing::Options => catalogue(&library).options,
    };
    let lines: String = rows.iter().map(|(name, about)| format!("{name}\t{about}\n")).collect();
    output::print(lines.as_bytes())
}
