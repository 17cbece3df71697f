//! The files for hosts: that a person can read them, that the host's own surroundings take them, and what stands where.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{HashMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use orogen::export::{Target, export, glsl, shadertoy_tabs};
use orogen::source::preset_names;
use orogen::syntax::{TokenKind, lex};
use orogen::{Bake, Compose, Library, Preset, Shader, Templates};

const SHADERTOY_PAGE: &str = include_str!("../xtask/src/shadertoy.frag");

fn composed(preset: &Preset, target: Target, bake: Bake) -> Shader {
    let mut composer = Compose::default();
    composer.stage = target.stage(None).unwrap();
    composer.run(&Library::standard(), preset, &target.bake(bake)).unwrap()
}

fn text(name: &str, target: Target, live: &[&str]) -> String {
    let shader = composed(&Preset::named(name).unwrap(), target, Bake::live(live.to_vec()));
    String::from_utf8(export(&shader, target, &Templates::standard()).unwrap()).unwrap()
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("glsl-hosts");
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn glslang(name: &str, text: &str) {
    let path = folder().join(name);
    fs::write(&path, text).unwrap();
    let output = Command::new("glslangValidator").args(["-S", "frag"]).arg(&path).output();
    let output = output.expect("glslangValidator is here: `cargo xtask test` installs it");
    assert!(output.status.success(), "{name}:\n{}", String::from_utf8_lossy(&output.stdout));
}

/// Names that the WGSL declares: functions, structs, constants, variables and parameters.
fn declared(wgsl: &str) -> HashSet<&str> {
    let tokens = lex(wgsl);
    let solid: Vec<_> = tokens.iter().filter(|(kind, _)| !kind.is_trivia()).collect();
    let word = |index: usize| solid.get(index).map_or("", |(_, span)| &wgsl[span.range()]);
    let mut names = HashSet::new();
    for index in 0..solid.len() {
        match word(index) {
            "fn" | "struct" | "let" | "const" => drop(names.insert(word(index + 1))),
            "var" if word(index + 1) != "<" => drop(names.insert(word(index + 1))),
            ":" if solid[index - 1].0 == TokenKind::Ident => drop(names.insert(word(index - 1))),
            _ => {}
        }
    }
    names.retain(|name| !matches!(*name, "default" | "fragment_main" | "vertex_main"));
    names
}

fn words(text: &str) -> HashSet<&str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').collect()
}

/// The comments of `text`, a line each, and how often each stands there.
fn comments(text: &str) -> HashMap<&str, usize> {
    let mut all = HashMap::new();
    for line in text.lines() {
        if let Some(at) = line.find("//") {
            *all.entry(line[at..].trim()).or_default() += 1;
        }
    }
    all
}

#[test]
fn every_preset_can_be_read_on_shadertoy() {
    let templates = Templates::standard();
    for name in preset_names() {
        let preset = Preset::named(name).unwrap();
        let shader = composed(&preset, Target::Shadertoy, Bake::default());
        let file = glsl(&shader, Target::Shadertoy, None, &templates).unwrap();
        // The text that it is made of, but for what a host of Shadertoy has in its own way.
        let standalone = composed(&preset, Target::Wgsl, Bake::default()).wgsl().to_owned();
        let wgsl = shader.wgsl();

        let renamed: HashMap<&str, &str> =
            file.renamed.iter().map(|(old, new)| (old.as_str(), new.as_str())).collect();
        let present = words(&file.text);
        let of_host = |word: &str| word.starts_with("frame_") || word == "position";
        let lost: Vec<_> = declared(wgsl)
            .into_iter()
            .filter(|word| !of_host(word) && !present.contains(renamed.get(word).unwrap_or(word)))
            .collect();
        assert!(lost.is_empty(), "{name}: names are lost: {lost:?}");
        assert!(file.renamed.len() < 20, "{name}: {:?}", file.renamed);

        let (kept, had) = (comments(&file.text), comments(&standalone));
        let total: usize = had.values().sum();
        let found: usize = had.iter().map(|(line, n)| (*n).min(kept.get(line).copied().unwrap_or(0))).sum();
        assert!(found * 100 >= total * 95, "{name}: {found} of {total} comments are kept");

        let (lines, before) = (file.text.lines().count(), standalone.lines().count());
        assert!(lines * 100 <= before * 115, "{name}: {lines} lines of {before}");
        let is_naga = |word: &&str| {
            word.strip_prefix("_e")
                .is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()))
        };
        assert!(!present.iter().any(|word| is_naga(&word)), "{name}");
        let endless = |text: &str| text.matches("while (true)").count() + text.matches("while(true)").count();
        assert!(endless(&file.text) <= endless(&standalone), "{name}");
        println!("{name}: {} bytes, {lines} lines of {before}, {found} of {total} comments", file.text.len());
    }
}

#[test]
fn live_parameters_come_first_and_are_plain_variables() {
    let text = text("lake", Target::Shadertoy, &["sun.*", "water.level"]);
    let at = |what: &str| text.find(what).unwrap_or_else(|| panic!("there is no `{what}`"));
    assert!(at("// ---- live parameters: change them here ----") < at("\nfloat sun_azimuth = "));
    assert!(at("\nfloat sun_azimuth = ") < at("// ---- camera ----"));
    assert!(at("\nfloat water_level = ") < at("// ---- camera ----"));
    assert!(!text.contains("#define"), "they can be animated by hand");
    assert!(text.contains("\nconst vec3 camera_position = vec3("));
}

#[test]
fn the_tabs_are_the_whole_shader_and_common_stands_alone() {
    for name in ["lake", "earth", "cumulus"] {
        let shader = composed(&Preset::named(name).unwrap(), Target::Shadertoy, Bake::live(["sun.*"]));
        let tabs = shadertoy_tabs(&shader, &Templates::standard()).unwrap();
        let both = format!("{SHADERTOY_PAGE}#line 1\n{}\n{}", tabs.common, tabs.image);
        glslang(&format!("{name}.tabs.frag"), &both);
        let alone = format!(
            "#version 300 es\nprecision highp float;\nprecision highp int;\n{}\nout vec4 c;\nvoid main() {{ c = vec4(0.0); }}\n",
            tabs.common
        );
        glslang(&format!("{name}.common.frag"), &alone);
        assert!(!words(&tabs.common).contains("iTime") && !words(&tabs.common).contains("iResolution"));
        assert!(tabs.image.contains("void mainImage(") && !tabs.common.contains("void mainImage("));
        assert!(tabs.image.contains(" main_image(") && !tabs.common.contains(" main_image("));
        assert!(tabs.common.contains("// ---- noise/pcg.wgsl ----"), "{}", tabs.common);
        assert!(tabs.image.len() < tabs.common.len(), "most is the library's");
    }
}

/// What an ISF host on WebGL 2 puts around a file.
fn in_isf(file: &str) -> String {
    let (json, code) = file.strip_prefix("/*").unwrap().split_once("*/").unwrap();
    let header: serde_json::Value = serde_json::from_str(json).unwrap();
    let mut page = "#version 300 es\nprecision highp float;\nprecision highp int;\nuniform int PASSINDEX;\n\
        uniform vec2 RENDERSIZE;\nuniform float TIME;\nuniform float TIMEDELTA;\nuniform vec4 DATE;\nuniform int FRAMEINDEX;\n\
        in vec2 isf_FragNormCoord;\nout vec4 isf_FragColor;\n"
        .to_owned();
    for input in header["INPUTS"].as_array().unwrap() {
        let ty = match input["TYPE"].as_str().unwrap() {
            "float" => "float",
            "bool" => "bool",
            "long" => "int",
            "color" => "vec4",
            "point2D" => "vec2",
            other => panic!("no type of ISF: {other}"),
        };
        page.push_str(&format!("uniform {ty} {};\n", input["NAME"].as_str().unwrap()));
    }
    page + &code.replace("gl_FragColor", "isf_FragColor")
}

#[test]
fn an_isf_file_has_its_live_parameters_as_inputs() {
    for (name, live) in
        [("alpine", "*"), ("lake", "sun.*"), ("earth", "*"), ("cumulus", "clouds.*"), ("night", "*")]
    {
        glslang(&format!("{name}.isf.frag"), &in_isf(&text(name, Target::Isf, &[live])));
    }
    let file = text("lake", Target::Isf, &["sun.*", "camera.position"]);
    let (json, code) = file.strip_prefix("/*").unwrap().split_once("*/").unwrap();
    let header: serde_json::Value = serde_json::from_str(json).unwrap();
    let input = |name: &str| {
        let all = header["INPUTS"].as_array().unwrap();
        all.iter().find(|input| input["NAME"] == name).unwrap_or_else(|| panic!("no input `{name}`")).clone()
    };
    let elevation = input("sun_elevation");
    assert_eq!((elevation["MIN"].as_f64(), elevation["MAX"].as_f64()), (Some(-90.0), Some(90.0)));
    assert_eq!(elevation["DEFAULT"].as_f64(), Some(7.5), "in degrees, as the preset has it");
    assert!(code.contains("radians(sun_elevation)"), "and the code reads radians");
    assert_eq!(input("sun_color")["TYPE"], "color");
    assert!(code.contains("sun_color.rgb"));
    assert_eq!(input("camera_position_y")["TYPE"], "float");
    assert!(code.contains("vec3(camera_position_x, camera_position_y, camera_position_z)"));
    assert_eq!(header["ISFVSN"], "2.0");
    let closing = Preset::of_text(
        "a.wgsl",
        "/// Ends */ here.\n#param g.a: f32 = 1.0, live\nfn main_image(p: vec2f) -> vec4f { return vec4f(g.a); }",
    );
    let shader = composed(&closing, Target::Isf, Bake::live(["g.*"]));
    let file = String::from_utf8(export(&shader, Target::Isf, &Templates::standard()).unwrap()).unwrap();
    glslang("closing.isf.frag", &in_isf(&file));
}

/// What compute.toys puts before a shader, as far as ours uses it.
const TOYS_PAGE: &str = "alias int = i32;\nalias uint = u32;\nalias float = f32;\n\
    struct Time { frame: u32, elapsed: f32, delta: f32 }\n\
    struct Mouse { pos: vec2u, zoom: f32, click: i32, start: vec2i, delta: vec2i }\n\
    @group(0) @binding(2) var<uniform> time: Time;\n@group(0) @binding(3) var<uniform> mouse: Mouse;\n\
    @group(0) @binding(5) var screen: texture_storage_2d<rgba16float, write>;\n";

#[test]
fn a_file_for_compute_toys_fits_behind_its_prelude() {
    for name in ["alpine", "lake", "earth", "cumulus", "night"] {
        let file = text(name, Target::ComputeToys, &["sun.*"]);
        let whole = format!("{TOYS_PAGE}{file}");
        let module = naga::front::wgsl::parse_str(&whole)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&whole)));
        naga::valid::Validator::new(naga::valid::ValidationFlags::all(), orogen::check::capabilities())
            .validate(&module)
            .unwrap();
        assert_eq!(module.entry_points.len(), 1, "{name}");
        assert_eq!(module.entry_points[0].workgroup_size, [16, 16, 1]);
        let of_host = ["frame_time", "frame_resolution", "frame_mouse", "frame_index", "frame_delta"];
        assert!(of_host.iter().all(|word| !words(&file).contains(word)), "{name}");
    }
    let taken = "#include <frame.wgsl>\nconst screen = 2.0;\nfn custom(time: f32) -> f32 { return time * screen; }\n\
        /// What it shows.\nfn main_image(p: vec2f) -> vec4f { return vec4f(custom(frame.time), p / frame.resolution, 1.0); }";
    let shader = composed(&Preset::of_text("a.wgsl", taken), Target::ComputeToys, Bake::default());
    let file =
        String::from_utf8(export(&shader, Target::ComputeToys, &Templates::standard()).unwrap()).unwrap();
    assert!(file.contains("const screen_ = 2.0;"), "{file}");
    assert!(file.contains("fn custom_(time: f32) -> f32 { return time * screen_; }"), "{file}");
    assert!(file.contains("/// What it shows.\nfn toys_picture(p: vec2f)"), "{file}");
    naga::front::wgsl::parse_str(&format!("{TOYS_PAGE}{file}")).unwrap();
}
