//! `orogen params`

use orogen::preset::listing;

use super::args::{Common, Params, ParamsFormat};
use super::failure::Outcome;
use super::{input, output};

pub(super) fn run(args: &Params, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let preset = input::preset(&args.preset, common)?;
    let mut composer = input::composer(common)?;
    composer.view.clone_from(&args.viewing.view);
    let survey = composer.survey(&library, &preset)?;
    let (declarations, settings) = (&survey.declarations, &survey.settings);
    let text = match args.format {
        ParamsFormat::Table => listing::table(declarations, settings),
        ParamsFormat::Json => listing::json(declarations, settings),
        ParamsFormat::Schema => listing::schema(declarations, &survey.scene),
        ParamsFormat::Markdown => listing::markdown(declarations, settings),
    };
    output::print(text.as_bytes())
}
