//! What the machine lacks, and how it gets here: through the system's own package manager, or npm for Tint and what drives the
//! browser.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::run::{Failure, Outcome, capture, cargo, command, read, root, run, shown, write};

/// Whether a chore may install what it needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Install {
    /// What is missing is installed.
    WhatIsMissing,
    /// What is missing is named, and the chore stops.
    Nothing,
}

/// Something from the system's packages.
struct Package {
    /// What it is, for people.
    name: &'static str,
    /// Its packages on Debian and Ubuntu, Fedora, and Arch.
    apt: &'static [&'static str],
    dnf: &'static [&'static str],
    pacman: &'static [&'static str],
}

const LAVAPIPE: Package = Package {
    name: "lavapipe (Mesa's software Vulkan driver)",
    apt: &["mesa-vulkan-drivers", "libvulkan1"],
    dnf: &["mesa-vulkan-drivers", "vulkan-loader"],
    pacman: &["vulkan-swrast", "vulkan-icd-loader"],
};
const GLSLANG: Package = Package {
    name: "glslang (glslangValidator)",
    apt: &["glslang-tools"],
    dnf: &["glslang"],
    pacman: &["glslang"],
};
const SPIRV_TOOLS: Package = Package {
    name: "SPIRV-Tools (spirv-val)",
    apt: &["spirv-tools"],
    dnf: &["spirv-tools"],
    pacman: &["spirv-tools"],
};
const NODE: Package = Package {
    name: "Node.js with npm",
    apt: &["nodejs", "npm"],
    dnf: &["nodejs", "npm"],
    pacman: &["nodejs", "npm"],
};

const CHROMIUM: Package =
    Package { name: "Chromium", apt: &["chromium"], dnf: &["chromium"], pacman: &["chromium"] };
const MESA_GL: Package = Package {
    name: "Mesa's software GL, for WebGL in Chromium",
    apt: &["libegl1", "libegl-mesa0", "libgl1-mesa-dri"],
    dnf: &["mesa-libEGL", "mesa-dri-drivers"],
    pacman: &["mesa"],
};

/// What distributions and Google call Chromium's program.
const BROWSERS: [&str; 5] =
    ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];

#[derive(Debug, Clone, Copy, PartialEq)]
enum Manager {
    Apt,
    Dnf,
    Pacman,
}

/// Installs Mesa's software Vulkan driver, whatever else is there.
pub(crate) fn lavapipe(install: Install) -> Outcome {
    packages(&[&LAVAPIPE], install)
}

/// What picks the Vulkan driver for tests: lavapipe, so that they draw the same pictures everywhere; nothing where the
/// person has picked one, or where there is no lavapipe to pick.
pub(crate) fn driver_for_tests() -> Option<(&'static str, PathBuf)> {
    if person_picked_driver() { None } else { Some(("VK_DRIVER_FILES", lavapipe_manifest()?)) }
}

/// Sees to it that the tests have a Vulkan driver. Only Linux needs one: Metal and Direct 3D come with their systems.
pub(crate) fn driver(install: Install) -> Outcome {
    if !cfg!(target_os = "linux") || person_picked_driver() || lavapipe_manifest().is_some() {
        return Ok(());
    }
    println!("The tests run on lavapipe. Set WGPU_ADAPTER_NAME to run them on an adapter of your own.");
    lavapipe(install)
}

/// Sees to it that glslang, SPIRV-Tools, Tint, and a browser with a GL to draw with are here.
pub(crate) fn judges(install: Install) -> Outcome {
    let wanted =
        [("glslangValidator", &GLSLANG), ("spirv-val", &SPIRV_TOOLS), ("node", &NODE), ("npm", &NODE)];
    let mut missing: Vec<&Package> = Vec::new();
    for (program, package) in wanted {
        if find(program).is_none() && !missing.iter().any(|known| known.name == package.name) {
            missing.push(package);
        }
    }
    if browser().is_none() {
        missing.push(&CHROMIUM);
    }
    if cfg!(target_os = "linux") && !has_egl() {
        missing.push(&MESA_GL);
    }
    packages(&missing, install)?;
    for (program, package) in wanted {
        if find(program).is_none() {
            let remedy = format!("its package was installed, but brought no `{program}` into PATH");
            return Err(Failure::Missing { what: package.name.to_owned(), remedy });
        }
    }
    if browser().is_none() {
        let remedy = format!(
            "its package was installed, but brought none of {} into PATH: set CHROMIUM to where it is",
            BROWSERS.join(", ")
        );
        return Err(Failure::Missing { what: CHROMIUM.name.to_owned(), remedy });
    }
    from_npm(install)
}

/// The browser that judges: the one that the person names in CHROMIUM, else one in PATH.
pub(crate) fn browser() -> Option<PathBuf> {
    let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
    named.or_else(|| BROWSERS.iter().find_map(|program| find(program)))
}

/// Sees to it that cargo has its formatter and its linter, which rustup's smallest profile leaves out.
pub(crate) fn formatter_and_linter(install: Install) -> Outcome {
    if ["fmt --version", "clippy --version"].iter().all(|line| capture(&mut cargo(line)).is_ok()) {
        return Ok(());
    }
    let mut rustup = command("rustup", &["component", "add", "rustfmt", "clippy"]);
    if install == Install::Nothing || find("rustup").is_none() {
        let remedy = format!("with rustup this installs it: {}", shown(&rustup));
        return Err(Failure::Missing { what: "rustfmt or clippy".to_owned(), remedy });
    }
    println!("rustfmt or clippy is missing: installing both");
    run(&mut rustup)
}

/// Installs Tint and what drives the browser as the lock file has them. Their packages' scripts stay blocked: Dawn comes ready
/// built, and playwright-core would fetch browsers of its own.
fn from_npm(install: Install) -> Outcome {
    const WHAT: &str = "Tint (npm package `webgpu`) or what drives the browser (`playwright-core`)";
    let folder = root().join("tests/judges");
    let lock = read(&folder.join("package-lock.json"))?;
    // A copy of the lock file inside tells what was installed, and that it was installed to the end.
    let installed = folder.join("node_modules/.installed-lock.json");
    if std::fs::read_to_string(&installed).is_ok_and(|known| known == lock) {
        return Ok(());
    }
    let mut npm = command("npm", &["ci", "--ignore-scripts", "--no-audit", "--no-fund"]);
    npm.current_dir(&folder);
    if install == Install::Nothing {
        let remedy = format!("this installs both: {}", shown(&npm));
        return Err(Failure::Missing { what: WHAT.to_owned(), remedy });
    }
    println!("{WHAT} is missing or out of date: installing both");
    run(&mut npm)?;
    write(&installed, &lock)
}

/// Installs `wanted` with the system's package manager, or says how one would.
fn packages(wanted: &[&Package], install: Install) -> Outcome {
    if wanted.is_empty() {
        return Ok(());
    }
    let what = wanted.iter().map(|package| package.name).collect::<Vec<_>>().join(", ");
    let manager = [("apt-get", Manager::Apt), ("dnf", Manager::Dnf), ("pacman", Manager::Pacman)]
        .into_iter()
        .find_map(|(program, manager)| find(program).map(|_| manager));
    let Some(manager) = manager else {
        let remedy = "neither apt-get, dnf nor pacman is here: please install it by hand".to_owned();
        return Err(Failure::Missing { what, remedy });
    };
    let is_root = capture(&mut command("id", &["-u"])).is_ok_and(|id| id.trim() == "0");
    let mut commands = commands(manager, wanted, is_root);
    let by_hand = || commands.iter().map(shown).collect::<Vec<_>>().join(" && ");
    if install == Install::Nothing {
        return Err(Failure::Missing { what, remedy: format!("this installs it: {}", by_hand()) });
    }
    if !is_root && find("sudo").is_none() {
        let remedy = format!("this needs root, and there is no sudo: {}", by_hand());
        return Err(Failure::Missing { what, remedy });
    }
    println!("{what} is missing: installing it");
    commands.iter_mut().try_for_each(run)
}

/// The commands that install `wanted`.
fn commands(manager: Manager, wanted: &[&Package], is_root: bool) -> Vec<Command> {
    // `env`: sudo drops variables. Without this one a package may stop and ask.
    let lines: &[&str] = match manager {
        Manager::Apt => &[
            "apt-get -qq update",
            "env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends",
        ],
        Manager::Dnf => &["dnf install -y"],
        Manager::Pacman => &["pacman -S --needed --noconfirm"],
    };
    let sudo = if is_root { "" } else { "sudo " };
    let as_root = |line: &&str| {
        let line = format!("{sudo}{line}");
        let mut words = line.split_whitespace();
        command(words.next().unwrap_or_default(), &words.collect::<Vec<_>>())
    };
    let mut commands: Vec<Command> = lines.iter().map(as_root).collect();
    if let Some(last) = commands.last_mut() {
        last.args(wanted.iter().flat_map(|package| match manager {
            Manager::Apt => package.apt,
            Manager::Dnf => package.dnf,
            Manager::Pacman => package.pacman,
        }));
    }
    commands
}

/// Whether the person has said which Vulkan driver or adapter to use.
fn person_picked_driver() -> bool {
    ["VK_DRIVER_FILES", "VK_ICD_FILENAMES", "WGPU_ADAPTER_NAME"]
        .iter()
        .any(|name| std::env::var_os(name).is_some())
}

/// The file that tells the Vulkan loader of lavapipe, for this machine's architecture.
fn lavapipe_manifest() -> Option<PathBuf> {
    let folders = ["/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"];
    let names = [format!("lvp_icd.{}.json", std::env::consts::ARCH), "lvp_icd.json".to_owned()];
    let paths = folders.iter().flat_map(|folder| names.iter().map(move |name| Path::new(folder).join(name)));
    paths.into_iter().find(|path| path.is_file())
}

/// Whether there is an EGL with Mesa's software driver behind it. Loaders and drivers lie in the folder of shared libraries, which
/// each distribution calls by another name.
fn has_egl() -> bool {
    let multiarch = format!("/usr/lib/{}-linux-gnu", std::env::consts::ARCH);
    let lies_in = |folder: &str, name: &str| Path::new(folder).join(name).exists();
    [multiarch.as_str(), "/usr/lib64", "/usr/lib"].iter().any(|folder| {
        let driver = ["dri/swrast_dri.so", "dri/libdril_dri.so"].iter().any(|name| lies_in(folder, name));
        driver && lies_in(folder, "libEGL.so.1") && lies_in(folder, "libEGL_mesa.so.0")
    })
}

/// Where `program` lies in PATH.
pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let names = [program.to_owned(), format!("{program}.exe"), format!("{program}.cmd")];
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path)
        .flat_map(|folder| names.clone().map(|name| folder.join(name)))
        .find(|at| at.is_file())
}

#[cfg(test)]
mod tests {
    use std::ffi::OsStr;

    use super::*;

    fn lines(manager: Manager, is_root: bool) -> Vec<String> {
        commands(manager, &[&GLSLANG, &SPIRV_TOOLS], is_root).iter().map(shown).collect()
    }

    #[test]
    fn apt_reads_its_lists_first_and_asks_nothing() {
        let expected = [
            "apt-get -qq update",
            "env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends glslang-tools spirv-tools",
        ];
        assert_eq!(lines(Manager::Apt, true), expected);
    }

    #[test]
    fn without_root_every_command_goes_through_sudo() {
        assert_eq!(lines(Manager::Dnf, false), ["sudo dnf install -y glslang spirv-tools"]);
        assert!(lines(Manager::Apt, false).iter().all(|line| line.starts_with("sudo ")));
    }

    #[test]
    fn a_program_is_found_where_the_path_says() {
        let cargo = find("cargo").expect("cargo runs this test");
        assert!(cargo.file_name().and_then(OsStr::to_str).is_some_and(|name| name.starts_with("cargo")));
        assert_eq!(find("orogen-has-no-such-program"), None);
    }
}
