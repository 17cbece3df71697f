//! `cargo xtask gallery`: a picture of every built-in preset, and the page that shows them.

use std::fs;
use std::path::PathBuf;

use crate::demo::see_to_adapter;
use crate::install::Install;
use crate::run::{Failure, Outcome, capture, cargo, create_folder, orogen, root, run, write};

/// The most that a picture may take: it travels with every clone.
const MOST_BYTES: u64 = 400_000;

/// Renders the presets called `names`, or all where none is named, and writes the page anew.
pub(crate) fn gallery(install: Install, names: &[String]) -> Outcome {
    run(&mut cargo("build --release"))?;
    let presets = presets(&capture(&mut orogen(&["list", "presets"])?)?);
    if let Some(unknown) = names.iter().find(|name| !presets.iter().any(|(preset, _)| preset == *name)) {
        return Err(Failure::Check(format!("there is no built-in preset named `{unknown}`")));
    }
    see_to_adapter(install)?;
    create_folder(&root().join("docs/gallery"))?;
    for (preset, _) in presets.iter().filter(|(preset, _)| names.is_empty() || names.contains(preset)) {
        let words = words(preset);
        run(&mut orogen(&words.iter().map(String::as_str).collect::<Vec<_>>())?)?;
    }
    for (preset, _) in &presets {
        hold_to_size(preset)?;
    }
    write(&root().join("docs/gallery.md"), &page(&presets))
}

/// `orogen list presets` → names, each with what it says about itself.
fn presets(list: &str) -> Vec<(String, String)> {
    let pairs = list.lines().filter_map(|line| line.split_once('\t'));
    pairs.map(|(name, about)| (name.to_owned(), about.trim().to_owned())).collect()
}

/// What makes a preset's picture.
fn words(preset: &str) -> Vec<String> {
    let picture = format!("docs/gallery/{preset}.jpg");
    ["render", preset, "--size", "960x540", "--samples", "2", "-o", &picture].map(str::to_owned).into()
}

fn hold_to_size(preset: &str) -> Outcome {
    let path: PathBuf = root().join(format!("docs/gallery/{preset}.jpg"));
    let bytes = match fs::metadata(&path) {
        Ok(meta) => meta.len(),
        Err(_) => {
            let why = format!("`{preset}` has no picture yet: `cargo xtask gallery {preset}` makes it");
            return Err(Failure::Check(why));
        }
    };
    if bytes > MOST_BYTES {
        let shown = path.display();
        return Err(Failure::Check(format!("{shown} takes {bytes} bytes, and {MOST_BYTES} are the most")));
    }
    Ok(())
}

fn page(presets: &[(String, String)]) -> String {
    let mut page = "# Gallery

The built-in presets. `cargo xtask gallery` draws these pictures and writes this page; `cargo xtask gallery NAME…` draws some
of them anew. `orogen params NAME` says what can be changed in each.
"
    .to_owned();
    for (preset, about) in presets {
        let words = words(preset).join(" ");
        page += &format!(
            "\n## {preset}\n\n{about}.\n\n![{preset}: {about}](gallery/{preset}.jpg)\n\n```sh\norogen {words}\n```\n"
        );
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_is_shown_with_what_makes_it() {
        let presets = presets("alpine\tA range in late light\ndunes\tSand\n");
        assert_eq!(presets.len(), 2);
        let page = page(&presets);
        for (preset, about) in &presets {
            assert!(page.contains(&format!("![{preset}: {about}](gallery/{preset}.jpg)")), "{page}");
            assert!(page.contains(&format!("orogen render {preset} --size")), "{page}");
        }
    }
}
