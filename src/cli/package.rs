//! `orogen export --target wesl -o DIR`: a folder of files, in the place of what an earlier export left there.

use std::fs;
use std::path::Path;

use orogen::export::Package;

use super::failure::{Failure, Outcome};
use super::output;

/// The file that says whose the folder is.
const LIST: &str = "wesl.toml";

/// Writes all files of `package` into `folder`, which is made where there is none, and takes away what only an earlier package
/// had there. A folder that holds something else is left as it is.
pub(super) fn write(folder: &Path, package: &Package) -> Outcome {
    let earlier = earlier(folder)?;
    for (path, _) in &package.files {
        if let Some(inside) = folder.join(path).parent() {
            fs::create_dir_all(inside).map_err(|why| fault(inside, &why))?;
        }
    }
    let paths: Vec<_> = package.files.iter().map(|(path, _)| folder.join(path)).collect();
    let texts = package.files.iter().map(|(_, text)| text.as_bytes());
    let drafts = paths.iter().zip(texts).map(|(path, text)| output::prepare(path, text));
    let drafts = drafts.collect::<Result<Vec<_>, _>>()?;
    drafts.into_iter().try_for_each(output::Draft::persist)?;
    for path in earlier.iter().filter(|path| package.file(path).is_none()) {
        remove(folder, path)?;
    }
    Ok(())
}

/// What an earlier package has in `folder`; nothing where it is empty, or is not there.
fn earlier(folder: &Path) -> Result<Vec<String>, Failure> {
    let Ok(mut entries) = fs::read_dir(folder) else {
        return if folder.exists() {
            Err(Failure::System(format!("`{}` cannot be written: it is not a folder", folder.display())))
        } else {
            Ok(Vec::new())
        };
    };
    if entries.next().is_none() {
        return Ok(Vec::new());
    }
    let listed = fs::read_to_string(folder.join(LIST)).ok().and_then(|text| Package::listed(&text));
    listed.ok_or_else(|| {
        Failure::System(format!(
            "`{}` is neither empty nor a WESL package that Orogen has written; nothing was written: \
             choose another folder",
            folder.display()
        ))
    })
}

/// Removes a file that a package has listed, and the folders that are empty without it.
fn remove(folder: &Path, listed: &str) -> Outcome {
    let Ok(inside) = orogen::source::join("", listed) else { return Ok(()) }; // it leads out: nobody of ours wrote that
    let path = folder.join(inside);
    match fs::remove_file(&path) {
        Err(why) if why.kind() != std::io::ErrorKind::NotFound => return Err(fault(&path, &why)),
        _ => {}
    }
    let mut parent = path.parent();
    while let Some(empty) = parent.filter(|parent| *parent != folder && fs::remove_dir(parent).is_ok()) {
        parent = empty.parent();
    }
    Ok(())
}

fn fault(path: &Path, why: &std::io::Error) -> Failure {
    Failure::System(format!("`{}` cannot be written: {why}", path.display()))
}
