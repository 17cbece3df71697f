//! Files of other people's packages, fetched when they are measured and never kept here: path in the package → text.

use std::path::PathBuf;
use std::process::Command;

use crate::Outcome;

pub(crate) const NPM: &str = "wgsl-noise@1.0.1";
const CRATE: &str = "noisy_bevy";
pub(crate) const CRATE_VERSION: &str = "0.15.0";

/// A file of npm's `wgsl-noise`, installed under `target/`, its scripts not run.
pub(crate) fn wgsl_noise(file: &str) -> Outcome<String> {
    let folder = root().join("target/peers");
    let place = folder.join("node_modules/wgsl-noise/src").join(file);
    if !place.exists() {
        std::fs::create_dir_all(&folder)?;
        let mut npm = Command::new("npm");
        let installed = npm
            .args(["install", "--silent", "--no-save", "--ignore-scripts", "--prefix"])
            .arg(&folder)
            .arg(NPM)
            .status()?;
        if !installed.success() {
            return Err(format!("npm could not install {NPM}").into());
        }
    }
    Ok(std::fs::read_to_string(place)?)
}

/// A file of the crate `noisy_bevy`. It depends on all of Bevy, so cargo is only asked about it: that fetches its source.
pub(crate) fn noisy_bevy(file: &str) -> Outcome<String> {
    let inside = PathBuf::from(format!("{CRATE}-{CRATE_VERSION}")).join(file);
    if let Some(place) = in_registry(&inside) {
        return Ok(std::fs::read_to_string(place)?);
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let asked =
        Command::new(cargo).args(["info", "--quiet", &format!("{CRATE}@{CRATE_VERSION}")]).output()?;
    let place = in_registry(&inside).ok_or_else(|| {
        format!("cargo did not fetch {CRATE} {CRATE_VERSION}: {}", String::from_utf8_lossy(&asked.stderr))
    })?;
    Ok(std::fs::read_to_string(place)?)
}

/// A file of a crate that cargo has unpacked.
fn in_registry(inside: &std::path::Path) -> Option<PathBuf> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cargo")))?;
    let registries = std::fs::read_dir(home.join("registry/src")).ok()?;
    registries.flatten().map(|registry| registry.path().join(inside)).find(|place| place.exists())
}

fn root() -> PathBuf {
    let peers = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    peers.parent().map_or(peers.clone(), PathBuf::from)
}
