//! What every fragment and preset of the library owes: it composes alone, and keeps to its floor.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;

use orogen::source::preset_names;
use orogen::syntax::{DeclarationKind, DirectiveKind, Fragment, parse_fragment, split};
use orogen::{Bake, Compose, Library, Preset};

/// The folders of each floor, from the ground up. `frame.wgsl` and `quality.wgsl` lie below all.
const FLOORS: [&[&str]; 5] = [
    &["math", "noise", "color"],
    &["fractal", "geometry", "light"],
    &["march"],
    &["camera", "sun", "terrain", "trees", "water", "sky", "clouds", "planet"],
    &["scene", "inspect"],
];

/// Floors that anybody can lift a file out of.
const PURE: usize = 3;

/// 1 for the lowest floor, 0 for what lies below all.
fn floor(path: &str) -> usize {
    let Some((folder, _)) = path.split_once('/') else {
        assert!(matches!(path, "frame.wgsl" | "quality.wgsl"), "{path} lies on no floor");
        return 0;
    };
    let at = FLOORS.iter().position(|folders| folders.contains(&folder));
    at.unwrap_or_else(|| panic!("{path} lies on no floor")) + 1
}

/// Every fragment of `wgsl/` with its path.
fn fragments() -> Vec<(String, Fragment)> {
    let library = Library::standard();
    let read = |path: String| {
        let text = fs::read_to_string(Path::new("wgsl").join(&path)).unwrap();
        assert_eq!(*library.find(&path).unwrap().text, *text, "{path} is embedded as it stands");
        (path, parse_fragment(text.into()))
    };
    library.modules().into_iter().map(read).collect()
}

#[test]
fn every_fragment_composes_and_validates_alone() {
    let library = Library::standard();
    let mut faults = Vec::new();
    for path in library.modules() {
        for bake in [Bake::constants(), Bake::live(["*"])] {
            if let Err(error) = orogen::compose(&library, &Preset::of_module(&path), &bake) {
                faults.push(format!("{path}:\n{error}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_fragment_includes_from_its_own_floor_or_below() {
    for (path, fragment) in fragments() {
        for placed in &fragment.directives {
            if let DirectiveKind::Include(include) = &placed.directive.kind {
                let target = orogen::source::join(
                    if include.beside { orogen::source::folder(&path) } else { "" },
                    &include.path.value,
                );
                let target = target.unwrap();
                assert!(floor(&target) <= floor(&path), "{path} includes {target}, which is higher");
            }
        }
    }
}

#[test]
fn the_lower_floors_are_pure() {
    for (path, fragment) in fragments() {
        if !(1..=PURE).contains(&floor(&path)) {
            continue;
        }
        for placed in &fragment.directives {
            let name = placed.directive.kind.name();
            assert!(!matches!(name, "param" | "option"), "{path} has a #{name}");
        }
        for truth in [true, false] {
            let module = split(&fragment, &vec![truth; fragment.conditions]);
            for declaration in &module.declarations {
                let kind = declaration.kind;
                assert!(
                    !matches!(kind, DeclarationKind::Var | DeclarationKind::Override),
                    "{path} has state"
                );
            }
        }
    }
}

#[test]
fn every_function_says_what_it_gives() {
    for (path, fragment) in fragments() {
        for truth in [true, false] {
            let module = split(&fragment, &vec![truth; fragment.conditions]);
            for declaration in module.declarations.iter().filter(|d| d.kind == DeclarationKind::Function) {
                let (symbol, _) = declaration.name.unwrap();
                let name = module.name(&fragment.text, symbol);
                let pieces = &module.pieces[declaration.pieces.clone()];
                let text: String = pieces.iter().map(|span| &fragment.text[span.range()]).collect();
                let head = text.trim_start().starts_with("///")
                    || text
                        .lines()
                        .take_while(|line| !line.contains("fn "))
                        .any(|l| l.trim().starts_with("///"));
                assert!(head, "`{name}` of {path} has no doc comment");
            }
        }
    }
}

#[test]
fn a_text_without_directives_comes_out_as_it_went_in() {
    let odd = [
        "\n\n  // late\n\n\nfn f() {}\n\n\n",
        "/* a *//* b */const A=1;;const B=2;",
        "\r\n// a\r\n\r\nconst A = 1;\r\n",
        "diagnostic(off, derivative_uniformity);\n\n\nconst A = 1; // b",
        "// only a comment",
        "",
    ];
    let library = fragments().into_iter().filter(|(_, fragment)| fragment.directives.is_empty());
    let library = library.map(|(_, fragment)| fragment.text.to_string());
    for text in library.chain(odd.map(str::to_owned)) {
        let mut compose = Compose::default();
        compose.keep_unused = true;
        let shader = compose.run(&Library::empty(), &Preset::of_text("text.wgsl", &text), &Bake::constants());
        let shader = shader.unwrap();
        assert!(shader.wgsl().ends_with(&text), "{text:?} became {:?}", shader.wgsl());
    }
}

#[test]
fn randomness_is_integer_hashing_only() {
    for (path, fragment) in fragments() {
        let plain: String = fragment.text.split_whitespace().collect();
        assert!(!plain.contains("fract(sin("), "{path} hashes with a sine");
    }
}

#[test]
fn every_preset_composes_in_every_baking() {
    let library = Library::standard();
    for name in preset_names() {
        let preset = Preset::named(name).unwrap();
        for bake in [
            Bake::constants(),
            Bake::constants().with_overrides(["*"]),
            Bake::live(["*"]),
            Bake::live(["sun.*"]).with_overrides(["camera.*"]), // what every scene has
        ] {
            let shader = orogen::compose(&library, &preset, &bake).unwrap();
            let size = shader.interface().uniform.as_ref().map_or(0, |uniform| uniform.size as usize);
            assert_eq!(shader.uniform_bytes(&preset).unwrap().len(), size, "{name}");
        }
    }
}

#[test]
fn presets_hold_no_unknown_key() {
    for name in preset_names() {
        let text = fs::read_to_string(format!("presets/{name}.json")).unwrap();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        for key in value.as_object().unwrap().keys() {
            assert!(
                ["$schema", "orogen", "about", "extends", "scene", "set"].contains(&key.as_str()),
                "{name} has a key {key}"
            );
        }
        assert!(value["about"].as_str().is_some_and(|about| !about.is_empty()), "{name} says what it is");
    }
}

#[test]
fn an_element_that_is_switched_off_leaves_no_code_behind() {
    // What switches it on, and what its names begin with.
    let elements: [(&str, &[&str]); 9] = [
        ("landscape.trees=true", &["trees_trace", "trees_shade", "crown_"]),
        ("landscape.water=true", &["water_"]),
        ("weather.clouds=true", &["cloud_", "clouds_"]),
        ("weather.second_layer=true", &["cirrus_cloud_", "cirrus_clouds_"]),
        ("weather.veil=true", &["planar_clouds_"]),
        ("weather.cirrus=true", &["cirrus_in", "cirrus_fbm2"]),
        ("moon.shines=true", &["moon_"]),
        ("stars.shine=true", &["star_", "milky_way_"]),
        ("sky.model=atmosphere", &["atmosphere_", "orders_"]),
    ];
    let library = Library::standard();
    let has = |preset: &Preset, prefix: &str| {
        let shader = orogen::compose(&library, preset, &Bake::constants()).unwrap();
        shader.wgsl().contains(&format!("fn {prefix}"))
    };
    let bare = Preset::of_module("scene/landscape.wgsl");
    for (switch, prefixes) in elements {
        let mut with = bare.clone();
        with.set(switch).unwrap();
        assert!(prefixes.iter().any(|prefix| has(&with, prefix)), "{switch} brings nothing in");
        for prefix in prefixes {
            assert!(!has(&bare, prefix), "without {switch} there is still a function `{prefix}…`");
        }
    }
}
