//! Rebuilds the crate when a file is added to or removed from the folders that it embeds.

fn main() {
    for folder in ["wgsl", "templates", "presets"] {
        println!("cargo::rerun-if-changed={folder}");
    }
}
