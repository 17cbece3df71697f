//! WESL packages: every module compiles to WGSL that naga accepts, and the pictures are those of `orogen render`.

mod harness;

use harness::{Device, add, compile, psnr, validate};
use orogen::export::{LibraryStyle, Package, library_features, library_package, package};
use orogen::render::{Shot, render};
use orogen::{Bake, Compose, Library, Preset, Shader, Templates};
use wesl::VirtualResolver;

/// A landscape, one with clouds and its camera in the air, and a planet.
const PRESETS: [&str; 3] = ["alpine", "flight", "earth"];

fn composed(preset: &Preset, bake: &Bake) -> (Shader, Package) {
    let shader = Compose::default().run(&Library::standard(), preset, bake).expect("it is valid");
    let package = package(&shader, &Templates::standard()).expect("it is written");
    (shader, package)
}

/// The package alone in a folder of its own.
fn alone(package: &Package) -> VirtualResolver<'_> {
    let mut resolver = VirtualResolver::new();
    add(&mut resolver, "", package);
    resolver
}

#[test]
fn every_module_of_a_preset_s_package_compiles_to_valid_wgsl() {
    for name in PRESETS {
        let (_, package) = composed(&Preset::named(name).expect("is built in"), &Bake::live(["sun.*"]));
        let resolver = alone(&package);
        let mut count = 0;
        for module in package.modules() {
            let wgsl = compile(&resolver, module, &[], true).unwrap_or_else(|why| panic!("{name}: {why}"));
            validate(&wgsl).unwrap_or_else(|why| panic!("{name}: {module}: {why}"));
            count += 1;
        }
        assert!(count > 30, "{name} has but {count} modules");
    }
}

#[test]
fn pictures_through_wesl_are_those_of_orogen_render() {
    let device = Device::new();
    for name in PRESETS {
        let preset = Preset::named(name).expect("is built in");
        let (shader, package) = composed(&preset, &Bake::constants());
        let wgsl = compile(&alone(&package), &package.root, &[], false).expect("it compiles");
        let shot = Shot::new(64, 36);
        let ours = render(&device.gpu(), &shader, &preset, &shot, &mut |_, _| {}).expect("it is drawn");
        let alike = psnr(&ours, &device.draw(&wgsl, &shader, &preset, &shot));
        println!("{name}: {alike:.1} dB");
        assert!(alike >= 50.0, "{name}: {alike:.1} dB");
    }
}

#[test]
fn every_module_of_the_whole_library_compiles_to_valid_wgsl() {
    let library = Library::standard();
    let package =
        library_package(&library, &LibraryStyle::default(), &Templates::standard()).expect("it is written");
    let resolver = alone(&package);
    let modules: Vec<_> = package.modules().collect();
    assert!(modules.len() > library.modules().len(), "each fragment is a module, and each instance");
    for module in modules {
        let wgsl = compile(&resolver, module, &[], true).unwrap_or_else(|why| panic!("{why}"));
        validate(&wgsl).unwrap_or_else(|why| panic!("{module}: {why}"));
    }
}

#[test]
fn the_whole_library_with_a_preset_s_features_draws_the_preset() {
    let device = Device::new();
    let (library, templates) = (Library::standard(), Templates::standard());
    for name in PRESETS {
        let preset = Preset::named(name).expect("is built in");
        let style = LibraryStyle { preset: Some(preset.clone()), ..LibraryStyle::default() };
        let whole = library_package(&library, &style, &templates).expect("it is written");
        let wgsl = compile(&alone(&whole), "main", &[], false).expect("it compiles");
        validate(&wgsl).unwrap_or_else(|why| panic!("{name}: {why}"));
        let (shader, package) = composed(&preset, &Bake::constants());
        let decided = compile(&alone(&package), "main", &[], false).expect("it compiles");
        let features = library_features(&library, &LibraryStyle::default(), &preset).expect("it fits");
        println!("{name}: {features:?}");
        println!("{name}: {} {}", wgsl.len(), decided.len());
        let shot = Shot::new(64, 36);
        let ours = render(&device.gpu(), &shader, &preset, &shot, &mut |_, _| {}).expect("it is drawn");
        let alike = psnr(&ours, &device.draw(&wgsl, &shader, &preset, &shot));
        println!("{name}: {alike:.1} dB");
        assert!(alike >= 50.0, "{name}: {alike:.1} dB");
    }
}
