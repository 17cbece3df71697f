//! WESL packages: every module compiles to WGSL that naga accepts, and the pictures are those of `orogen render`.

#![allow(
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it has measured"
)]

mod harness;

use harness::{Device, add, compile, frame, module, psnr, validate};
use orogen::export::{LibraryStyle, Package, library_features, library_package, package};
use orogen::render::{Picture, Shot, render};
use orogen::source::preset_names;
use orogen::{Bake, Compose, Library, Preset, Shader, Templates};
use wesl::VirtualResolver;

/// A landscape, one with clouds and its camera in the air, and a planet.
const PRESETS: [&str; 3] = ["alpine", "flight", "earth"];

/// Small: software GPUs draw it in seconds.
const SHOT: Shot =
    Shot { width: 64, height: 36, samples: 1, time: 0.0, delta: None, index: 0, mouse: None, tile: None };

fn composed(preset: &Preset, bake: &Bake) -> (Shader, Package) {
    let shader = Compose::default().run(&Library::standard(), preset, bake).expect("it is valid");
    let package = package(&shader, &Templates::standard()).expect("it is written");
    (shader, package)
}

/// The package alone in a folder of its own.
fn alone(package: &Package) -> VirtualResolver<'_> {
    let mut resolver = VirtualResolver::new();
    add(&mut resolver, package);
    resolver
}

#[test]
fn every_module_of_a_preset_s_package_compiles_to_valid_wgsl() {
    let bake = Bake::live(["sun.*"]).with_overrides(["camera.*"]);
    for name in PRESETS {
        let (_, package) = composed(&Preset::named(name).expect("is built in"), &bake);
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
fn a_generic_fragment_s_package_has_its_slots_among_the_parameters() {
    for path in ["fractal/jets.wgsl", "march/volume.wgsl"] {
        let (_, package) = composed(&Preset::of_module(path), &Bake::constants().with_overrides(["*"]));
        let resolver = alone(&package);
        for module in package.modules() {
            let wgsl = compile(&resolver, module, &[], true).unwrap_or_else(|why| panic!("{path}: {why}"));
            validate(&wgsl).unwrap_or_else(|why| panic!("{path}: {module}: {why}"));
        }
        assert!(
            package
                .file("parameters.wesl")
                .is_some_and(|text| text.contains("put a function of your own here"))
        );
    }
}

/// What the module `main` of `resolver` draws with `features`.
fn drawn(device: &Device, resolver: &VirtualResolver<'_>, features: &[String]) -> Picture {
    let wgsl = compile(resolver, "main", features, false).unwrap_or_else(|why| panic!("{why}"));
    validate(&wgsl).unwrap_or_else(|why| panic!("{why}"));
    let parameters = resolver.get_module(&module("parameters")).expect("there are some");
    device.draw(&wgsl, "fragment_main", &[(0, 0, frame(parameters, &SHOT))], &SHOT)
}

/// What `orogen render` draws.
fn rendered(device: &Device, preset: &Preset) -> Picture {
    let (shader, _) = composed(preset, &Bake::constants());
    render(&device.gpu(), &shader, preset, &SHOT, &mut |_, _| {}).expect("it is drawn")
}

fn assert_alike(what: &str, a: &Picture, b: &Picture) {
    let alike = psnr(a, b);
    println!("{what}: {alike:.1} dB");
    assert!(alike >= 50.0, "{what}: {alike:.1} dB");
}

/// Two roads to a preset's picture: its own package; and the whole library as it is, with the features of the preset's options on
/// and its constants put in. A third, the whole library with its values as defaults, is compiled only.
fn draws_as_orogen_render_does(name: &str) {
    let device = Device::new();
    let (library, templates) = (Library::standard(), Templates::standard());
    let preset = Preset::named(name).expect("is built in");
    let ours = rendered(&device, &preset);
    let (_, package) = composed(&preset, &Bake::constants());
    assert_alike(name, &ours, &drawn(&device, &alone(&package), &[]));

    let plain = library_package(&library, &LibraryStyle::default(), &templates).expect("it is written");
    let style = LibraryStyle { preset: Some(preset.clone()), ..LibraryStyle::default() };
    let with_values = library_package(&library, &style, &templates).expect("it is written");
    let wgsl = compile(&alone(&with_values), "main", &[], false).unwrap_or_else(|why| panic!("{why}"));
    validate(&wgsl).unwrap_or_else(|why| panic!("{why}"));
    let features = library_features(&library, &LibraryStyle::default(), &preset).expect("it fits");
    assert!(!features.is_empty(), "{name} differs from the defaults");
    let file = |package: &Package, path: &str| package.file(path).expect("it is there").to_owned();
    let values = file(&with_values, "parameters.wesl");
    let values = with_constants(&file(&plain, "parameters.wesl"), &values, |_| true);
    let mut resolver = alone(&plain);
    resolver.add_module(module("parameters"), values.into());
    resolver.add_module(module("main"), file(&with_values, "main.wesl").into());
    assert_alike(&format!("{name} by features"), &ours, &drawn(&device, &resolver, &features));
}

#[test]
fn a_landscape_through_wesl_is_that_of_orogen_render() {
    draws_as_orogen_render_does("alpine");
}

#[test]
fn a_view_from_among_clouds_through_wesl_is_that_of_orogen_render() {
    draws_as_orogen_render_does("flight");
}

#[test]
fn a_planet_through_wesl_is_that_of_orogen_render() {
    draws_as_orogen_render_does("earth");
}

#[test]
fn a_constant_that_is_changed_does_what_the_preset_s_parameter_does() {
    let device = Device::new();
    let mut preset = Preset::named("alpine").expect("is built in");
    let (_, mut package) = composed(&preset, &Bake::constants());
    let before = drawn(&device, &alone(&package), &[]);
    preset.set("sun.elevation=5").expect("is a parameter");
    preset.set("sun.color=[1, 0.4, 0.1]").expect("is a parameter");
    let (_, other) = composed(&preset, &Bake::constants());
    let of_other = other.file("parameters.wesl").expect("it is there").to_owned();
    let parameters =
        package.files.iter_mut().find(|(path, _)| path == "parameters.wesl").expect("it is there");
    parameters.1 = with_constants(&parameters.1, &of_other, |name| name.starts_with("sun_"));
    let after = drawn(&device, &alone(&package), &[]);
    assert!(psnr(&before, &after) < 30.0, "the sun is lower and redder");
    assert_alike("a lower sun", &rendered(&device, &preset), &after);
}

/// `parameters` with those constants of `other` that `wanted` says.
fn with_constants(parameters: &str, other: &str, wanted: impl Fn(&str) -> bool) -> String {
    let name = |line: &str| Some(line.strip_prefix("const ")?.split_once(':')?.0.to_owned());
    let mut text = String::new();
    for line in parameters.lines() {
        let same = name(line).filter(|known| wanted(known));
        let changed = same.and_then(|known| other.lines().find(|line| name(line).as_ref() == Some(&known)));
        text += changed.unwrap_or(line);
        text.push('\n');
    }
    text
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

/// A library in small: what each thing of our language becomes.
fn small() -> Library {
    let noise = "// Noise.\n\nfn rough(p: vec2f) -> f32 {\n    return p.x;\n}\n";
    let sum = "\
// A sum of any noise.

/// What is summed.
#slot noise: fn(p: vec2f) -> f32

/// How much of it.
#param strength.gain: f32 = 0.5, range 0 .. 1

/// The sum.
fn sum(p: vec2f) -> f32 {
    return strength.gain * noise(p);
}
";
    let land = "\
// The land.

#include <noise.wgsl>
#include <sum.wgsl> as hills with noise = rough

/// Whether there is a sea.
#option land.sea = true
/// What the land is like.
#option land.kind = flat { flat, hilly, steep }
/// How many times it is looked at.
#option land.looks = 4, range 1 .. 16

#if land.kind >= hilly && land.looks > 8
const FORMS: i32 = 3;
#elif land.kind >= hilly
const FORMS: i32 = 2;
#else
const FORMS: i32 = 1;
#endif

/// Its height.
fn land_height(p: vec2f) -> f32 {
    var height = 0.0;
#if land.kind != flat
    height = hills_sum(p);
#endif
#if land.sea
    return max(height, 0.0);
#else
    return height;
#endif
}
";
    Library::empty().with_file("noise.wgsl", noise).with_file("sum.wgsl", sum).with_file("land.wgsl", land)
}

#[test]
fn options_become_features_and_instances_modules() {
    let package =
        library_package(&small(), &LibraryStyle::default(), &Templates::standard()).expect("it is written");
    let land = "\
// The land.

import super::sum::hills::hills_sum;

@if((land_kind_hilly || land_kind_steep) && land_looks_16)
const FORMS: i32 = 3;
@if((land_kind_hilly || land_kind_steep) && !land_looks_16)
const FORMS: i32 = 2;
@if(!land_kind_hilly && !land_kind_steep)
const FORMS: i32 = 1;

/// Its height.
fn land_height(p: vec2f) -> f32 {
    var height = 0.0;
    @if(land_kind_hilly || land_kind_steep) height = hills_sum(p);
    @if(!no_land_sea) return max(height, 0.0);
    @if(no_land_sea) return height;
}
";
    assert_eq!(package.file("land.wesl"), Some(land));
    let hills = "\
// A sum of any noise.

import super::super::noise::rough as noise;
import super::super::parameters::hills_gain;

/// The sum.
fn hills_sum(p: vec2f) -> f32 {
    return hills_gain * noise(p);
}
";
    assert_eq!(package.file("sum/hills.wesl"), Some(hills));
    let resolver = alone(&package);
    for features in
        [&[] as &[&str], &["land_kind_hilly"], &["land_kind_steep", "land_looks_16", "no_land_sea"]]
    {
        let features: Vec<_> = features.iter().map(|name| (*name).to_owned()).collect();
        for module in package.modules() {
            let wgsl = compile(&resolver, module, &features, true).unwrap_or_else(|why| panic!("{why}"));
            validate(&wgsl).unwrap_or_else(|why| panic!("{module}: {why}"));
        }
    }
}

/// The module of the scene that the built-in preset `name`, or one that it extends, names.
fn scene(name: &str) -> String {
    let path = format!("{}/../../presets/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("it is there");
    let value = |key: &str| Some(text.split_once(&format!("\"{key}\": \""))?.1.split_once('"')?.0.to_owned());
    match value("scene") {
        Some(scene) => scene.trim_end_matches(".wgsl").to_owned(),
        None => scene(&value("extends").expect("it has a scene from somewhere")),
    }
}

#[test]
fn the_features_of_every_preset_make_its_scene_valid() {
    let library = Library::standard();
    let plain =
        library_package(&library, &LibraryStyle::default(), &Templates::standard()).expect("it is written");
    let resolver = alone(&plain);
    for name in preset_names() {
        let preset = Preset::named(name).expect("is built in");
        let features = library_features(&library, &LibraryStyle::default(), &preset).expect("it fits");
        let scene = scene(name);
        let wgsl = compile(&resolver, &scene, &features, true).unwrap_or_else(|why| panic!("{name}: {why}"));
        validate(&wgsl).unwrap_or_else(|why| panic!("{name}: {scene}: {why}"));
    }
}

/// The snippet in `language` number `index` of the page about Bevy.
fn snippet(language: &str, index: usize) -> String {
    let page = include_str!("../../../docs/bevy.md");
    let fence = format!("```{language}\n");
    let start = page.match_indices(&fence).nth(index).expect("there is one").0 + fence.len();
    page[start..].split_once("```").expect("it ends").0.to_owned()
}

/// What `docs/bevy.md` says about shaders holds; Bevy itself is not built.
#[test]
fn the_shader_for_bevy_compiles_and_draws_the_sky() {
    let preset = Preset::named("golden-hour").expect("is built in");
    let bake = Bake::live(["sun.azimuth", "sun.elevation"]).at_binding(3, 0);
    let mut composer = Compose::default();
    composer.module = Some("sky/sky.wgsl".into());
    let shader = composer.run(&Library::standard(), &preset, &bake).expect("it is valid");
    let package = package(&shader, &Templates::standard()).expect("it is written");
    let text = snippet("wgsl", 0);
    let folder = tempfile::tempdir().expect("it can be made");
    let files = package.files.iter().map(|(path, text)| (format!("orogen/{path}"), text));
    for (path, text) in files.chain([("sky.wesl".into(), &text)]) {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().expect("it has one")).expect("it can be made");
        std::fs::write(path, text).expect("it can be written");
    }
    // As the page's `build.rs` does it.
    let shaders = wesl::Wesl::new(folder.path());
    let sky =
        shaders.compile(&"package::sky".parse().expect("it is a path")).unwrap_or_else(|why| panic!("{why}"));
    let wgsl = sky.to_string();
    validate(&wgsl).unwrap_or_else(|why| panic!("{why}"));

    // The fields of the structure in Rust are those of the buffer, in their order.
    let rust = snippet("rust", 1);
    let fields =
        rust.split_once("struct OrogenParams {").expect("it is there").1.split_once('}').expect("it ends").0;
    let fields: Vec<_> = fields.lines().filter_map(|line| Some(line.trim().split_once(':')?.0)).collect();
    let uniform = shader.interface().uniform.as_ref().expect("the sun is live");
    assert_eq!(fields, uniform.fields.iter().map(|field| field.name.as_str()).collect::<Vec<_>>());
    assert_eq!((uniform.group, uniform.binding), (3, 0));

    // The same fragment through Orogen alone.
    let host: String =
        text.lines().filter(|line| !line.starts_with("import ")).collect::<Vec<_>>().join("\n");
    let library = Library::standard().with_file("host.wgsl", format!("#include <sky/sky.wgsl>\n{host}\n"));
    composer.module = Some("host.wgsl".into());
    let host = composer.run(&library, &preset, &bake).expect("it is valid");
    let eye: Vec<u8> = [0.0f32, 2.0, 0.0, 1.0].iter().flat_map(|value| value.to_le_bytes()).collect();
    let device = Device::new();
    let buffers = [(3, 0, shader.uniform_bytes(&preset).expect("it fits")), (3, 1, eye)];
    let ours = device.draw(host.wgsl(), "fragment", &buffers, &SHOT);
    let theirs = device.draw(&wgsl, "fragment", &buffers, &SHOT);
    assert!(ours.pixels.iter().any(|pixel| pixel[2] > 0.05), "there is light in the sky");
    assert_alike("the sky for Bevy", &ours, &theirs);
}
