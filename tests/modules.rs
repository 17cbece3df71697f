//! Modules for a host's own shader, and how little is done again when something changes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use naga::valid::{ValidationFlags, Validator};
use orogen::compose::Work;
use orogen::{Bake, Compose, Library, Preset, Shader, check};

fn is_valid(wgsl: &str) {
    let module =
        naga::front::wgsl::parse_str(wgsl).unwrap_or_else(|error| panic!("{}", error.emit_to_string(wgsl)));
    let mut validator = Validator::new(ValidationFlags::all(), check::capabilities());
    validator.validate(&module).unwrap_or_else(|error| panic!("{}", error.emit_to_string(wgsl)));
}

/// The names of module scope in `shader`.
fn names(shader: &Shader) -> Vec<String> {
    let module = &shader.checked().module;
    let types = module.types.iter().filter_map(|(_, ty)| ty.name.clone());
    let constants = module.constants.iter().filter_map(|(_, constant)| constant.name.clone());
    let overrides = module.overrides.iter().filter_map(|(_, one)| one.name.clone());
    let globals = module.global_variables.iter().filter_map(|(_, variable)| variable.name.clone());
    let functions = module.functions.iter().filter_map(|(_, function)| function.name.clone());
    let entries = module.entry_points.iter().map(|entry| entry.name.clone());
    types.chain(constants).chain(overrides).chain(globals).chain(functions).chain(entries).collect()
}

#[test]
fn every_module_of_the_library_takes_a_prefix_in_every_name_and_stays_valid() {
    let library = Library::standard();
    let bakes = [Bake::constants(), Bake::live(["*"]), Bake::constants().with_overrides(["*"])];
    for path in library.modules() {
        for bake in &bakes {
            let module = library.module(&path).with_bake(bake.clone()).with_prefix("og_").unwrap();
            let shader = module.compose().unwrap_or_else(|error| panic!("{path}: {error}"));
            let plain: Vec<_> = names(&shader).into_iter().filter(|name| !name.starts_with("og_")).collect();
            assert!(plain.is_empty(), "{path}: {plain:?}");
        }
    }
}

#[test]
fn modules_under_two_prefixes_lie_in_one_shader_without_a_collision() {
    let library = Library::standard();
    let module = |prefix: &str, binding| {
        let module = library.module("sky/scattering.wgsl").with_prefix(prefix).unwrap();
        module.with_bake(Bake::live(["sky.*"]).at_binding(1, binding)).compose().unwrap()
    };
    let (day, night) = (module("day_", 0), module("night_", 1));
    let host = "\
        @fragment fn main(@builtin(position) p: vec4f) -> @location(0) vec4f {\n\
        \x20   let direction = normalize(p.xyz);\n\
        \x20   let day = day_atmosphere_radiance(0.0, direction, vec3f(0.0, 1.0, 0.0));\n\
        \x20   return vec4f(day + night_atmosphere_radiance(0.0, direction, vec3f(0.0, 0.0, 1.0)), 1.0);\n\
        }\n";
    is_valid(&format!("{}\n{}\n{host}", day.wgsl(), night.wgsl()));
    for (shader, binding) in [(&day, 0), (&night, 1)] {
        let uniform = shader.interface().uniform.as_ref().unwrap();
        assert_eq!((uniform.group, uniform.binding), (1, binding));
    }
}

#[test]
fn a_module_pulls_in_nothing_that_it_does_not_use() {
    let lines = |module: orogen::Module| module.compose().unwrap().wgsl().lines().count();
    let library = Library::standard();
    let air = || library.module("sky/atmosphere.wgsl");
    assert!(lines(air()) < 250, "{}", lines(air()));
    assert!(lines(air().with_bake(Bake::live(["*"]))) < 250);
    assert!(lines(air().only(["atmosphere_transmittance"])) < lines(air()));
    let text = air().compose().unwrap().wgsl().to_owned();
    for foreign in ["camera", "sun_", "moon", "stars", "orders_", "phase_"] {
        assert!(!text.contains(foreign), "the air speaks of {foreign}:\n{text}");
    }
}

#[test]
fn a_module_has_the_values_of_the_preset_that_it_is_given() {
    let preset = Preset::named("alpine").unwrap();
    let whole = orogen::compose(&Library::standard(), &preset, &Bake::constants()).unwrap();
    let land = Library::standard().module("terrain/height.wgsl").with_preset(preset).compose().unwrap();
    let constants = |text: &str| -> Vec<String> {
        text.lines().filter(|line| line.starts_with("const terrain_")).map(str::to_owned).collect()
    };
    let of_whole = constants(whole.wgsl());
    let of_land = constants(land.wgsl());
    assert!(of_land.len() > 5 && of_land.iter().all(|line| of_whole.contains(line)), "{of_land:#?}");
    assert!(!land.wgsl().contains("main_image"));
}

#[test]
fn what_naga_says_of_a_prefixed_module_stands_in_the_author_s_file() {
    let library = Library::empty().with_file(
        "a.wgsl",
        "fn half(x: f32) -> f32 {\n    return x * two();\n}\n\nfn two() -> i32 {\n    return 2;\n}\n",
    );
    let error = library.module("a.wgsl").with_prefix("og_").unwrap().compose().err().unwrap();
    let label = error.diagnostics()[0].labels.iter().find(|label| label.primary).unwrap();
    let file = error.files().get(label.file);
    assert_eq!((&*file.name, file.slice(label.span)), ("a.wgsl", "x * two()"));
}

/// What composing did anew.
fn anew(before: Work, after: Work) -> [usize; 3] {
    [after.fragments - before.fragments, after.splits - before.splits, after.selections - before.selections]
}

#[test]
fn another_value_of_a_constant_reads_splits_and_shakes_nothing_again() {
    let (library, bake) = (Library::standard(), Bake::live(["sun.*"]));
    let mut preset = Preset::named("alpine").unwrap();
    let mut compose = Compose::default();
    let first = compose.run(&library, &preset, &bake).unwrap();
    let before = compose.work();
    preset.set("terrain.peak_height=2345").unwrap();
    let second = compose.run(&library, &preset, &bake).unwrap();
    assert_eq!(anew(before, compose.work()), [0, 0, 0]);
    let pairs = first.wgsl().lines().zip(second.wgsl().lines());
    let changed: Vec<_> =
        pairs.filter(|(a, b)| a != b).map(|(_, b)| b.split("  //").next().unwrap()).collect();
    assert_eq!(changed, ["const terrain_peak_height: f32 = 2345.0;"]);
    // And it is what composing all of it gives, to the last segment of the source map.
    let fresh = orogen::compose(&library, &preset, &bake).unwrap();
    assert_eq!(second.wgsl(), fresh.wgsl());
    assert_eq!(orogen::export::source_map(&second, "a.wgsl"), orogen::export::source_map(&fresh, "a.wgsl"));
}

#[test]
fn another_option_reads_nothing_again_and_splits_what_asks_for_it() {
    let (library, bake) = (Library::standard(), Bake::constants());
    let mut preset = Preset::named("alpine").unwrap();
    let mut compose = Compose::default();
    compose.run(&library, &preset, &bake).unwrap();
    let before = compose.work();
    preset.set("quality=low").unwrap();
    compose.run(&library, &preset, &bake).unwrap();
    let [fragments, splits, selections] = anew(before, compose.work());
    assert_eq!((fragments, selections), (0, 1));
    assert!(splits < before.splits / 2, "{splits} of {}", before.splits);
    // Back again: all of it is known.
    let before = compose.work();
    preset.set("quality=high").unwrap();
    compose.run(&library, &preset, &bake).unwrap();
    assert_eq!(anew(before, compose.work()), [0, 0, 0]);
}

#[test]
fn an_edit_reads_one_fragment_again() {
    let library = |text: &str| {
        Library::empty()
            .with_file("a.wgsl", "#include <b.wgsl>\nfn a() -> f32 {\n    return b() + 1.0;\n}\n")
            .with_file("b.wgsl", format!("fn b() -> f32 {{\n    return {text};\n}}\n"))
    };
    let preset = Preset::of_module("a.wgsl");
    let mut compose = Compose::default();
    compose.run(&library("1.0"), &preset, &Bake::constants()).unwrap();
    let before = compose.work();
    let shader = compose.run(&library("2.0"), &preset, &Bake::constants()).unwrap();
    assert_eq!(anew(before, compose.work()), [1, 1, 1]);
    assert!(shader.wgsl().contains("return 2.0;"));
}

#[test]
fn a_live_parameter_changes_its_own_bytes_and_no_more() {
    let library = Library::standard();
    let mut preset = Preset::named("alpine").unwrap();
    let shader = orogen::compose(&library, &preset, &Bake::live(["sun.*", "terrain.*"])).unwrap();
    let uniform = shader.interface().uniform.as_ref().unwrap();
    let mut bytes = shader.uniform_bytes(&preset).unwrap();
    assert_eq!(shader.update_uniform(&mut bytes, &preset).unwrap(), 0..0);
    preset.set("sun.elevation=4").unwrap();
    let changed = shader.update_uniform(&mut bytes, &preset).unwrap();
    assert_eq!(Some(changed), uniform.range("sun.elevation"));
    assert_eq!(bytes, shader.uniform_bytes(&preset).unwrap());
    // Two of one group: one stretch inside of the group.
    preset.set("sun.elevation=5").unwrap();
    preset.set("sun.azimuth=5").unwrap();
    let changed = shader.update_uniform(&mut bytes, &preset).unwrap();
    let group = uniform.range("sun").unwrap();
    assert!(changed.start >= group.start && changed.end <= group.end, "{changed:?} {group:?}");
    // What is wrong leaves them alone.
    let before = bytes.clone();
    preset.set("sun.elevation=900").unwrap();
    shader.update_uniform(&mut bytes, &preset).unwrap_err();
    assert_eq!(bytes, before);
    // A buffer of another size is written whole.
    preset.set("sun.elevation=5").unwrap();
    assert_eq!(shader.update_uniform(&mut Vec::new(), &preset).unwrap(), 0..uniform.size as usize);
}

/// The packages in a lock file: name and version.
fn locked(path: &str) -> Vec<(String, String)> {
    let text = std::fs::read_to_string(path).unwrap();
    let value = |line: &str, key: &str| -> Option<String> {
        Some(line.strip_prefix(key)?.strip_prefix(" = \"")?.strip_suffix('"')?.to_owned())
    };
    let lines: Vec<_> = text.lines().collect();
    let pairs = lines.windows(2);
    pairs.filter_map(|pair| Some((value(pair[0], "name")?, value(pair[1], "version")?))).collect()
}

#[test]
fn whoever_has_wgpu_30_gets_no_second_naga() {
    // The newcomer's crate has a wgpu of its own, and Orogen with what checks. (Ours also lists what peers are measured with.)
    let all = locked("tests/newcomer/Cargo.lock");
    for name in ["naga", "wgpu"] {
        let versions: Vec<_> = all.iter().filter(|(known, _)| known == name).map(|(_, v)| v).collect();
        assert!(matches!(versions[..], [one] if one.starts_with("30.")), "{name} {versions:?}");
    }
}

#[test]
fn the_newcomer_s_crate_needs_nothing_that_is_not_here() {
    let ours = locked("Cargo.lock");
    for package in locked("tests/newcomer/Cargo.lock") {
        let is_here = package.0 == "newcomer" || ours.contains(&package);
        assert!(is_here, "{package:?}: copy Cargo.lock into tests/newcomer and run `cargo check` there");
    }
}
