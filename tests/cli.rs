//! The `orogen` binary, as somebody at a terminal or a script meets it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn orogen(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the binary starts")
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_orogen"));
    command.args(arguments);
    command
}

fn status(output: &Output) -> i32 {
    output.status.code().expect("it exits by itself")
}

fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("there is room for a folder")
}

fn put(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path = folder.path().join(name);
    fs::create_dir_all(path.parent().expect("it is in a folder")).expect("folders can be made");
    fs::write(&path, text).expect("it can be written");
    path.display().to_string()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("it is a folder");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("it can be read").path()).collect();
    paths.sort();
    paths
}

#[test]
fn help_teaches_every_command() {
    let help = orogen(&["--help"]);
    assert_eq!(status(&help), 0);
    for word in [
        "export",
        "check",
        "render",
        "params",
        "list",
        "eval",
        "heightmap",
        "Exit status",
        "orogen export alpine",
    ] {
        assert!(out(&help).contains(word), "{word}");
    }
    for command in ["export", "check", "render", "params", "list", "eval", "heightmap"] {
        assert_eq!(status(&orogen(&[command, "--help"])), 0, "{command}");
    }
    assert!(out(&orogen(&["--version"])).starts_with("orogen 0."));
}

#[test]
fn minify_writes_less_and_its_map_beside_it() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let (long, short) = (at("long.wgsl"), at("short.wgsl"));
    assert_eq!(status(&orogen(&["export", "dunes", "-o", &long])), 0);
    assert_eq!(status(&orogen(&["export", "dunes", "--minify", "--source-map", "-o", &short])), 0);
    let size = |path: &str| fs::metadata(path).expect("it was written").len();
    assert!(size(&short) * 3 < size(&long));
    assert!(size(&(short.clone() + ".map")) > 1000);
    assert_eq!(status(&orogen(&["check", &short])), 0, "what was written is a shader");
    let glsl = orogen(&["export", "dunes", "--minify", "--target", "glsl"]);
    assert!(out(&glsl).starts_with("#version 300 es\n// dunes: "), "{}", out(&glsl));
}

#[test]
fn what_makes_no_sense_exits_with_2() {
    for arguments in [
        &[] as &[&str],
        &["exprot", "alpine"],
        &["export"],
        &["export", "alpine", "--target", "pdf"],
        &["export", "alpine", "--source-map"],
        &["export", "alpine", "--target", "wesl"],
        &["export", "--target", "wesl"],
        &["export", "--target", "wesl", "--only", "pcg", "-o", "no/such/folder"],
        &["export", "--target", "wesl", "--set", "sun.elevation=6", "-o", "no/such/folder"],
        &["export", "alpine", "--target", "wesl", "--minify", "-o", "no/such/folder"],
        &["export", "alpine", "--minify", "--target", "spirv"],
        &["export", "alpine", "--minify", "--target", "json"],
        &["export", "alpine", "--target", "glsl", "--stage", "compute"],
        &["render", "alpine", "--size", "0x5"],
        &["render", "alpine", "--size", "banana"],
        &["render", "alpine", "--size", "99999999999x5"],
        &["render", "alpine", "--samples", "0"],
        &["render", "alpine", "--time", "inf"],
        &["render", "alpine", "--frames", "0"],
        &["render", "alpine", "--frames", "2", "--fps", "-3"],
        &["render", "alpine", "--fps", "24"],
        &["render", "alpine", "--mouse", "1,2,3"],
        &["render", "alpine", "--mouse", "1,2,3,nan"],
        &["render", "alpine", "--mouse", "1,2,3,4,5"],
        &["render", "alpine", "--projection", "fisheye"],
        &["render", "alpine", "--faces"],
        &["render", "alpine", "--watch"],
        &["heightmap", "alpine", "--origin", "1000"],
        &["heightmap", "alpine", "--origin", "0.0001,0"],
        &["heightmap", "alpine", "--size", "0"],
        &["heightmap", "alpine", "--size", "-5"],
        &["heightmap", "alpine", "--pixels", "many"],
        &["heightmap", "alpine", "--range", "5,1"],
        &["heightmap", "alpine", "--range", "nan,1"],
        &["export", "alpine", "--live", " "],
        &["export", "alpine", "--overrides", "sun.*,"],
        &["export", "<noise/perlin.wgsl"],
        &["params", "alpine", "--format", "xml"],
        &["list", "everything"],
        &["check"],
        &["check", "alpine", "-I", "no/such/folder"],
        &["export", "alpine", "--templates", "no/such/folder"],
    ] {
        let output = orogen(arguments);
        assert_eq!(status(&output), 2, "{arguments:?}: {}", err(&output));
        assert!(!err(&output).is_empty(), "{arguments:?}");
        assert!(out(&output).is_empty(), "{arguments:?}");
    }
}

#[test]
fn wrong_input_exits_with_1_and_says_why() {
    let folder = folder();
    let broken = put(&folder, "broken.wgsl", "fn main() -> f32 { return nothing; }\n");
    let bare = put(&folder, "bare.wgsl", "fn main_image(p: vec2f) -> vec4f { return vec4f(1.0); }\n");
    let preset = put(
        &folder,
        "preset.json",
        "{\"orogen\": 1, \"extends\": \"alpine\", \"set\": {\"sun\": {\"azimut\": 3}}}",
    );
    for (arguments, says) in [
        (&["export", "alpin"] as &[&str], "did you mean `alpine`?"),
        (&["export", "no/such.wgsl"], "was not found"),
        (&["export", "no/such.json"], "cannot be read"),
        (&["check", &broken], "broken.wgsl:1:27"),
        (&["export", &preset], "did you mean `sun.azimuth`?"),
        (&["export", "alpine", "--set", "sun.elevation=120"], "out of range"),
        (&["export", "alpine", "--set", "sun.elevation"], "there is no `=`"),
        (&["export", "alpine", "--set", "=3"], "there is no name"),
        (&["export", "alpine", "--live", "son.*"], "matches no parameter"),
        (&["export", "alpine", "--overrides", "quality"], "this is an option"),
        (&["export", "no/such.txt"], "a preset's file ends in .json"),
        (&["check", "Cargo.toml"], "a preset's file ends in .json"),
        (&["export", "<noise/perlim.wgsl>"], "did you mean `noise/perlin.wgsl`?"),
        (&["render", "alpine", "-o", "picture.bmp"], "png"),
        (&["render", "<noise/perlin.wgsl>", "-o", "picture.png"], "entry point"),
        (&["render", "alpine", "--view", "stpes", "-o", "picture.png"], "did you mean `steps`?"),
        (&["render", &bare, "--projection", "cube", "-o", "picture.png"], "error[OR0914]"),
        (&["render", "dunes", "--projection", "cube", "--size", "64x32", "-o", "x.png"], "error[OR0909]"),
        (&["heightmap", "alpine", "-o", "land.jpg"], "error[OR0935]"),
        (&["heightmap", "flight", "-o", "land.png"], "error[OR0930]"),
        (&["heightmap", "alpine", "--pixels", "1", "-o", "land.png"], "error[OR0931]"),
        (&["heightmap", "alpine", "--footprint=-1", "-o", "land.png"], "error[OR0931]"),
        (&["export", "alpine", "--view", "../scene/landscape"], "there is no debug view"),
        (&["export", "alpine", "--view", "sight"], "there is no debug view"),
        (&["export", "alpine", "--view", "steps", "--set", "display.exposed=1"], "`display.exposure`?"),
        (&["export", "alpine", "--view", "steps", "--set", "inspect.most_step=1"], "`inspect.most_steps`?"),
        (&["export", "alpine", "--set", "inspect.most_steps=1"], "no parameter or option named"),
    ] {
        let output = orogen(arguments);
        assert_eq!(status(&output), 1, "{arguments:?}: {}", err(&output));
        assert!(err(&output).contains(says), "{arguments:?}: {}", err(&output));
        assert!(out(&output).is_empty(), "{arguments:?}");
    }
}

#[test]
fn export_writes_each_target() {
    let folder = folder();
    for (target, starts) in [
        ("wgsl", "//"),
        ("shadertoy", "//"),
        ("glsl", "#version 300 es"),
        ("hlsl", "//"),
        ("msl", "//"),
        ("json", "{"),
        ("spirv", "\u{3}\u{2}#\u{7}"),
    ] {
        let path = folder.path().join(target);
        let shown = path.display().to_string();
        let output = orogen(&["export", "dunes", "--target", target, "-o", &shown]);
        assert_eq!(status(&output), 0, "{target}: {}", err(&output));
        let bytes = fs::read(&path).expect("it was written");
        assert!(bytes.starts_with(starts.as_bytes()), "{target}");
    }
    assert_eq!(files(folder.path()).len(), 7, "no temporary file is left");
    let printed = orogen(&["export", "dunes"]);
    let written = fs::read(folder.path().join("wgsl")).expect("it was written");
    assert_eq!(printed.stdout, written, "standard output gets the same");
}

/// The files in `folder` and below, by their paths.
fn tree(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut ahead = vec![folder.to_owned()];
    while let Some(inside) = ahead.pop() {
        for entry in fs::read_dir(inside).expect("it is a folder") {
            let path = entry.expect("it can be read").path();
            if path.is_dir() {
                ahead.push(path);
            } else {
                let path = path.strip_prefix(folder).expect("it is inside").display().to_string();
                found.push(path.replace('\\', "/"));
            }
        }
    }
    found.sort();
    found
}

#[test]
fn a_wesl_package_takes_the_place_of_an_earlier_one_and_of_nothing_else() {
    let folder = folder();
    let package = folder.path().join("package");
    let shown = package.display().to_string();
    let wesl =
        |what: &[&str], to: &str| orogen(&[&["export"], what, &["--target", "wesl", "-o", to]].concat());
    let output = wesl(&["dunes"], &shown);
    assert_eq!(status(&output), 0, "{}", err(&output));
    let files = tree(&package);
    for file in ["README.md", "wesl.toml", "main.wesl", "parameters.wesl", "terrain/dunes.wesl"] {
        assert!(files.iter().any(|known| known == file), "{file}: {files:#?}");
    }
    // What is not of the package stays, and what is no longer of it goes.
    fs::write(package.join("terrain/mine.wesl"), "fn mine() {}\n").expect("it can be written");
    let output = wesl(&["<noise/perlin.wgsl>"], &shown);
    assert_eq!(status(&output), 0, "{}", err(&output));
    let files = tree(&package);
    assert!(files.iter().any(|file| file == "noise/perlin.wesl"), "{files:#?}");
    assert!(files.iter().any(|file| file == "terrain/mine.wesl"), "{files:#?}");
    assert!(!files.iter().any(|file| file == "terrain/dunes.wesl"), "{files:#?}");
    assert!(!package.join("scene").exists(), "an empty folder goes, too");

    let other = folder.path().join("other");
    fs::create_dir(&other).expect("it can be made");
    fs::write(other.join("wesl.toml"), "edition = \"2026_pre\"\n").expect("it can be written");
    let output = wesl(&["dunes"], &other.display().to_string());
    assert_eq!(status(&output), 1);
    let said = err(&output);
    assert!(said.contains("is neither empty nor a WESL package that Orogen has written"), "{said}");
    assert_eq!(tree(&other), ["wesl.toml"]);
    let file = put(&folder, "file", "");
    let output = wesl(&["dunes"], &file);
    assert_eq!(status(&output), 1);
    assert!(err(&output).contains("it is not a folder"), "{}", err(&output));
}

#[test]
fn a_failed_run_leaves_the_file_as_it_was() {
    let folder = folder();
    let target = put(&folder, "alpine.wgsl", "precious");
    let output = orogen(&["export", "alpine", "--set", "sun.elevation=120", "-o", &target]);
    assert_eq!(status(&output), 1);
    assert_eq!(fs::read_to_string(&target).expect("it is there"), "precious");
    assert_eq!(files(folder.path()).len(), 1);

    let nowhere = folder.path().join("no/such/folder/x.wgsl").display().to_string();
    let output = orogen(&["export", "alpine", "-o", &nowhere]);
    assert_eq!(status(&output), 1);
    assert!(err(&output).contains("no/such/folder` does not exist"), "{}", err(&output));
    assert!(!err(&output).contains(".orogen-"), "{}", err(&output));
}

#[test]
fn a_shader_is_not_written_over_what_it_is_made_of() {
    let folder = folder();
    let part = put(&folder, "part.wgsl", "const one = 1;\n");
    let root = put(&folder, "root.wgsl", "#include \"part.wgsl\"\nconst two = one + 1;\n");
    let preset = put(&folder, "preset.json", "{\"orogen\": 1, \"scene\": \"root.wgsl\"}");
    let before: Vec<_> = [&part, &root, &preset].map(|path| fs::read(path).expect("it is there")).into();
    for (what, target) in [(&root, &root), (&root, &part), (&preset, &preset), (&preset, &root)] {
        let output = orogen(&["export", what, "-o", target]);
        assert_eq!(status(&output), 1, "{what} over {target}");
        assert!(err(&output).contains("is one of the files"), "{}", err(&output));
    }
    let after: Vec<_> = [&part, &root, &preset].map(|path| fs::read(path).expect("it is there")).into();
    assert_eq!(before, after);

    let scene = "#include \"part.png\"\nfn main_image(p: vec2f) -> vec4f { return vec4f(f32(one)); }\n";
    let scene = put(&folder, "scene.wgsl", scene);
    let part = put(&folder, "part.png", "const one = 1;\n");
    let output = orogen(&["render", &scene, "--size", "4x4", "-o", &part]);
    assert_eq!(status(&output), 1, "{}", err(&output));
    assert!(err(&output).contains("is one of the files"), "{}", err(&output));

    let other = put(&folder, "noise/pcg.wgsl", "of the same name as one of the library's");
    let output = command(&["export", "<noise/pcg.wgsl>", "-o", "noise/pcg.wgsl"])
        .current_dir(folder.path())
        .output()
        .expect("it starts");
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert!(fs::read_to_string(other).expect("it is there").contains("fn pcg"));

    // A byte order mark is not part of the text that was read, and protects no less.
    let marked = put(&folder, "marked.wgsl", "\u{feff}const one = 1;\n");
    let output = orogen(&["export", &marked, "-o", &marked]);
    assert_eq!(status(&output), 1, "{}", err(&output));
    assert!(fs::read_to_string(&marked).expect("it is there").starts_with('\u{feff}'));
}

#[test]
fn a_file_and_its_map_are_written_both_or_neither() {
    let folder = folder();
    for (blocked, other) in [("a.wgsl", "a.wgsl.map"), ("b.wgsl.map", "b.wgsl")] {
        fs::create_dir(folder.path().join(blocked)).expect("folders can be made");
        let target = folder.path().join(blocked.trim_end_matches(".map")).display().to_string();
        let output = orogen(&["export", "dunes", "--source-map", "-o", &target]);
        assert_eq!(status(&output), 1, "{}", err(&output));
        assert!(!folder.path().join(other).exists(), "{other}");
    }
    assert_eq!(files(folder.path()).len(), 2, "no temporary file is left");
}

#[cfg(unix)]
#[test]
fn a_file_keeps_its_permissions_and_a_link_stays_one() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder();
    let old = put(&folder, "old.wgsl", "old");
    fs::set_permissions(&old, fs::Permissions::from_mode(0o640)).expect("it is ours");
    assert_eq!(status(&orogen(&["export", "dunes", "-o", &old])), 0);
    assert_eq!(fs::metadata(&old).expect("it is there").permissions().mode() & 0o777, 0o640);

    let link = folder.path().join("link.wgsl");
    symlink("new.wgsl", &link).expect("links can be made");
    let output = orogen(&["export", "dunes", "-o", &link.display().to_string()]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert!(fs::symlink_metadata(&link).expect("it is there").is_symlink());
    assert_eq!(fs::read(folder.path().join("new.wgsl")).ok(), fs::read(&old).ok());
}

#[test]
fn overrides_that_a_target_does_not_have_are_told() {
    for (target, told) in [("wgsl", false), ("json", false), ("glsl", true)] {
        let arguments = ["export", "dunes", "--target", target, "--overrides", "sun.*, sky.*"];
        let output = orogen(&arguments);
        assert_eq!(status(&output), 0, "{}", err(&output));
        assert_eq!(err(&output).contains("note: glsl has no pipeline overrides"), told, "{}", err(&output));
    }
    let quiet = orogen(&["export", "dunes", "--target", "glsl", "--overrides", "sun.*", "--quiet"]);
    assert!(err(&quiet).is_empty());
}

#[test]
fn a_source_map_stands_beside_its_file() {
    let folder = folder();
    let path = folder.path().join("dunes.wgsl").display().to_string();
    let output = orogen(&["export", "dunes", "--source-map", "-o", &path]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    let map = fs::read_to_string(path + ".map").expect("it was written");
    let map: serde_json::Value = serde_json::from_str(&map).expect("a source map is JSON");
    assert_eq!(map["version"], 3);
    assert_eq!(map["file"], "dunes.wgsl");
}

#[test]
fn check_tells_tools_in_json_lines() {
    let folder = folder();
    let broken = put(&folder, "broken.wgsl", "// é\nfn main() -> f32 { /* é */ return nothing; }\n");
    let output = orogen(&["check", "alpine", &broken, "--message-format", "json"]);
    assert_eq!(status(&output), 1);
    let text = out(&output);
    let lines: Vec<serde_json::Value> =
        text.lines().map(|line| serde_json::from_str(line).expect("each line is JSON")).collect();
    assert_eq!(lines.len(), 1, "alpine is right: {text}");
    let line = &lines[0];
    assert_eq!(line["severity"], "error");
    assert_eq!(line["code"], "OR0701");
    let span = &line["spans"][0];
    assert_eq!(span["file"], broken.as_str());
    assert_eq!([&span["line"], &span["column"]], [2, 35], "columns are characters: {span}");
    assert_eq!([&span["end_line"], &span["end_column"]], [2, 42], "{span}");
    assert_eq!(span["primary"], true);
    for key in ["message", "notes", "help"] {
        assert!(line.get(key).is_some(), "{key}");
    }
}

#[test]
fn check_reads_presets_scenes_and_modules() {
    let output = orogen(&["check", "alpine", "dunes", "canyon", "<noise/perlin.wgsl>", "<fractal/fbm.wgsl>"]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert!(out(&output).is_empty());
    assert!(err(&output).contains("5 checked, no errors"), "{}", err(&output));
    assert!(err(&orogen(&["check", "alpine", "--quiet"])).is_empty());
}

#[test]
fn check_sums_up() {
    let folder = folder();
    let broken = put(&folder, "broken.wgsl", "fn f() -> f32 { return nothing; }\n");
    for (arguments, says) in [
        (&["check", "alpine"] as &[&str], "1 checked, no errors\n"),
        (&["check", &broken], "1 checked, it has errors\n"),
        (&["check", "alpine", &broken, "dunes"], "3 checked, 1 with errors\n"),
        (&["check", "no/such.txt", "dunes"], "2 checked, 1 with errors\n"),
    ] {
        let output = orogen(arguments);
        assert!(err(&output).ends_with(says), "{arguments:?}: {}", err(&output));
    }
}

#[test]
fn an_extension_may_be_in_capitals() {
    let folder = folder();
    let preset = put(&folder, "DAWN.JSON", "{\"orogen\": 1, \"extends\": \"alpine\"}");
    let fragment = put(&folder, "ONE.WGSL", "const one = 1;\n");
    let output = orogen(&["check", &preset, &fragment]);
    assert_eq!(status(&output), 0, "{}", err(&output));
}

#[test]
fn a_folder_named_like_a_preset_hides_it_not() {
    let folder = folder();
    fs::create_dir(folder.path().join("dunes")).expect("folders can be made");
    let output = command(&["check", "dunes"]).current_dir(folder.path()).output().expect("it starts");
    assert_eq!(status(&output), 0, "{}", err(&output));
}

#[test]
fn lists_are_a_name_a_tab_and_what_it_is() {
    for what in ["presets", "scenes", "views", "modules", "options"] {
        let output = orogen(&["list", what]);
        assert_eq!(status(&output), 0);
        assert!(!out(&output).is_empty(), "{what}");
        for line in out(&output).lines() {
            let (name, about) = line.split_once('\t').expect("a tab");
            assert!(!name.is_empty() && !about.is_empty(), "{what}: {line}");
        }
    }
    assert!(out(&orogen(&["list", "scenes"])).contains("scene/landscape.wgsl\t"));
    assert!(!out(&orogen(&["list", "scenes"])).contains("inspect/"), "a view is no scene of its own");
}

#[test]
fn every_view_suits_the_scenes_that_have_what_it_shows() {
    let names = |what: &str| {
        let list = out(&orogen(&["list", what]));
        list.lines().filter_map(|line| Some(line.split_once('\t')?.0.to_owned())).collect::<Vec<_>>()
    };
    let views = names("views");
    assert!(
        views.iter().any(|view| view == "steps") && !views.iter().any(|view| view == "sight"),
        "{views:?}"
    );
    let scenes = names("scenes").into_iter().map(|scene| format!("<{scene}>"));
    let presets: Vec<String> = names("presets").into_iter().chain(scenes).collect();
    for view in &views {
        let suits = |preset: &&String| {
            let output = orogen(&["export", preset, "--view", view, "--live", "*"]);
            if err(&output).contains("error[OR0308]") {
                assert_eq!(status(&output), 1);
                return false;
            }
            assert_eq!(status(&output), 0, "{preset} {view}: {}", err(&output));
            assert!(out(&output).contains(&format!(" (view {view})")), "{preset} {view}: {}", out(&output));
            true
        };
        let suited: Vec<_> = presets.iter().filter(suits).collect();
        assert!(!suited.is_empty(), "{view} suits nothing");
        let is_land = !view.starts_with("cloud_");
        assert!(!is_land || suited.iter().any(|preset| *preset == "alpine"), "{view} shows no land");
    }
}

#[test]
fn a_view_of_land_says_that_a_sky_has_none() {
    let output = orogen(&["export", "<scene/sky.wgsl>", "--view", "steps"]);
    assert_eq!(status(&output), 1);
    let says = "the view `steps` shows what the scene `scene/sky.wgsl` does not have: `terrain`";
    assert!(err(&output).contains(says), "{}", err(&output));
    for view in ["optical_depth", "transmittance"] {
        let output = orogen(&["export", "<scene/sky.wgsl>", "--view", view]);
        assert_eq!(status(&output), 0, "the air is there without land: {}", err(&output));
    }
}

#[test]
fn a_view_has_parameters_of_its_own_beside_the_scene_s() {
    let table = out(&orogen(&["params", "alpine", "--view", "slice", "--set", "inspect.slice_z=-50"]));
    let line = table.lines().find(|line| line.starts_with("inspect.slice_z ")).expect("it is the view's");
    assert!(line.contains(" -50 "), "{line}");
    assert!(table.lines().any(|line| line.starts_with("display.exposure ")), "what the scene has can be set");
    assert!(!out(&orogen(&["params", "alpine"])).contains("inspect."), "a scene has none of a view's");
}

#[test]
fn a_view_is_a_picture() {
    let folder = folder();
    let mut command = command(&["render", "dunes", "--view", "normals", "--size", "32x18"]);
    let output = command.current_dir(folder.path()).output().expect("it starts");
    assert_eq!(status(&output), 0, "{}", err(&output));
    let picture = image::open(folder.path().join("dunes_normals.png")).expect("it has the view in its name");
    let (sky, ground) = (picture.to_rgb8().get_pixel(16, 1).0, picture.to_rgb8().get_pixel(16, 17).0);
    assert!(sky.iter().all(|value| (62..=72).contains(value)), "nothing is grey: {sky:?}");
    assert!(ground[1] > 200, "ground faces up: {ground:?}");
}

#[test]
fn a_view_of_ones_own_is_a_file_in_a_folder_over_the_library() {
    let folder = folder();
    let text = "// Where it is high.\n#include <terrain/height.wgsl>\n\
                fn main_image(p: vec2f) -> vec4f { return vec4f(step(900.0, terrain_height(p))); }\n";
    put(&folder, "inspect/high.wgsl", text);
    let dir = folder.path().display().to_string();
    let output = orogen(&["export", "alpine", "--view", "high", "-I", &dir]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert!(out(&orogen(&["list", "views", "-I", &dir])).contains("high\tWhere it is high.\n"));
}

#[test]
fn params_come_in_four_forms() {
    let table = out(&orogen(&["params", "alpine", "--set", "sun.elevation=6"]));
    let line =
        table.lines().find(|line| line.starts_with("sun.elevation ")).expect("the sun has an elevation");
    assert!(line.contains("f32") && line.contains(" 6 ") && line.contains("-90 .. 90 deg"), "{line}");
    assert!(out(&orogen(&["params", "alpine", "--format", "markdown"])).starts_with("| name |"));
    for format in ["json", "schema"] {
        let text = out(&orogen(&["params", "alpine", "--format", format]));
        let json: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
        assert!(json.is_object());
    }
}

#[test]
fn a_folder_over_the_library_wins() {
    let folder = folder();
    put(&folder, "noise/pcg.wgsl", "// Ours.\nfn pcg(v: u32) -> u32 { return v + 41u; }\n");
    let dir = folder.path().display().to_string();
    let output = orogen(&["export", "<noise/pcg.wgsl>", "-I", &dir]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert!(out(&output).contains("v + 41u"));
}

#[test]
fn a_template_of_ones_own_changes_the_look() {
    let folder = folder();
    put(
        &folder,
        "wgsl.jinja",
        "// Mine: {{ name }}\n{% for module in modules %}{{ module.lines[0] }}{% endfor %}",
    );
    let source = put(&folder, "one.wgsl", "const one = 1;\n");
    let dir = folder.path().display().to_string();
    let output = orogen(&["export", &source, "--templates", &dir]);
    assert_eq!(out(&output), "// Mine: one\nconst one = 1;\n", "{}", err(&output));
    put(&folder, "wgsl.jinja", "{{ no_such_name }}");
    let output = orogen(&["export", &source, "--templates", &dir]);
    assert_eq!(status(&output), 1);
    assert!(err(&output).contains("wgsl.jinja"), "{}", err(&output));
}

#[test]
fn a_reader_that_has_had_enough_is_no_failure() {
    let mut child =
        command(&["export", "alpine"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("starts");
    drop(child.stdout.take()); // as `| head -0` does
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert!(err(&output).is_empty(), "{}", err(&output));
}

#[test]
fn eval_reads_points_and_writes_csv() {
    let folder = folder();
    let points = put(&folder, "points.csv", "x,y\n0.5,0.25\n-3,1e3\n");
    let arguments = ["eval", "vec2f(x + y, p.x)", "--points", &points];
    let output = orogen(&arguments);
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert_eq!(out(&output), "x,y\n0.75,0.5\n997.0,-3.0\n");

    let mut child = command(&["eval", "i * 2u", "--points", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    child.stdin.take().expect("it reads").write_all(b"i:u32\n4000000000\n7\n").expect("it listens");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(out(&output), "value\n3705032704\n14\n", "integers wrap");

    assert_eq!(out(&orogen(&["eval", "1.5 + 2.0"])), "value\n3.5\n");
    assert_eq!(out(&orogen(&["eval", "-1.0"])), "value\n-1.0\n");
    let noise =
        orogen(&["eval", "perlin_noise2(p, 7u)", "--include", "<noise/perlin.wgsl>", "--points", &points]);
    assert_eq!(out(&noise).lines().count(), 3, "{}", err(&noise));
}

#[test]
fn eval_includes_files_on_disk() {
    let folder = folder();
    let beside = put(&folder, "lib/beside.wgsl", "fn half(x: f32) -> f32 { return 0.5 * x; }\n");
    let absolute = put(
        &folder,
        "lib/mine.wgsl",
        "#include \"beside.wgsl\"\nfn quarter(x: f32) -> f32 { return half(half(x)); }\n",
    );
    put(&folder, "other/beside.wgsl", "fn third(x: f32) -> f32 { return x / 3.0; }\n");
    for (file, call) in [
        (&*absolute, "quarter(2.0)"),
        ("lib/mine.wgsl", "quarter(2.0)"),
        ("lib/mine.wgsl as my", "my_quarter(2.0)"),
    ] {
        let mut command = command(&["eval", call, "--include", file]);
        let output = command.current_dir(folder.path()).output().expect("it starts");
        assert_eq!(out(&output), "value\n0.5\n", "{file}: {}", err(&output));
    }
    let mut command = command(&["eval", "half(1.0)", "--include", &beside, "--include", "other/beside.wgsl"]);
    let output = command.current_dir(folder.path()).output().expect("it starts");
    assert_eq!(status(&output), 1);
    assert!(err(&output).contains("is hidden by"), "{}", err(&output));
}

#[test]
fn eval_says_what_is_wrong_with_the_points() {
    let folder = folder();
    for (csv, says) in [
        ("x,y\n1\n", "line 2"),
        ("x\n1\nbanana\n", "line 3"),
        ("x:u32\n-1\n", "line 2: `-1` is out of the range of u32"),
        ("x:i32\n1.5\n", "`1.5` is not of type i32"),
        ("x\n1e39\n", "`1e39` is out of the range of f32"),
        ("x:f64\n1\n", "f64"),
        ("x,x\n1,2\n", "x"),
        ("9x\n1\n", "9x"),
        ("", "header"),
    ] {
        let points = put(&folder, "points.csv", csv);
        let output = orogen(&["eval", "1.0", "--points", &points]);
        assert_eq!(status(&output), 1, "{csv:?}: {}", err(&output));
        assert!(err(&output).contains(says), "{csv:?}: {}", err(&output));
    }
}

#[test]
fn render_writes_pictures_and_sequences() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let scene = put(
        &folder,
        "ramp.wgsl",
        "#include <frame.wgsl>\nfn main_image(p: vec2f) -> vec4f { return vec4f(p / frame.resolution, fract(frame.time), 1.0); }\n",
    );
    let output = orogen(&["render", &scene, "--size", "32x16", "-o", &path("ramp.png")]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    let picture = image::open(path("ramp.png")).expect("it is a PNG").to_rgb8();
    assert_eq!(picture.dimensions(), (32, 16));
    assert!(
        picture.get_pixel(31, 0)[1] > 240 && picture.get_pixel(31, 15)[1] < 16,
        "the origin is at the bottom"
    );
    let output = orogen(&["render", &scene, "--size", "8x8", "-o", &path("ramp.exr")]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    let output =
        orogen(&["render", &scene, "--size", "8x8", "--frames", "3", "--fps", "4", "-o", &path("seq.png")]);
    assert_eq!(status(&output), 0, "{}", err(&output));
    for (index, blue) in [(1, 0u8), (2, 64), (3, 128)] {
        let frame = image::open(path(&format!("seq_000{index}.png"))).expect("it is numbered").to_rgb8();
        assert!(frame.get_pixel(0, 0)[2].abs_diff(blue) <= 2, "frame {index}: {:?}", frame.get_pixel(0, 0));
    }
}

#[test]
fn a_picture_is_taken_at_the_time_of_its_preset() {
    let folder = folder();
    let scene = put(
        &folder,
        "clock.wgsl",
        "#include <frame.wgsl>
fn main_image(p: vec2f) -> vec4f { return vec4f(fract(frame.time), f32(frame.index) / 255.0, 0.0, 1.0); }\n",
    );
    let set = ["--set", "frame.time=0.25", "--set", "frame.index=40"];
    for (more, name, expected) in [
        (&[] as &[&str], "clock.png", [64, 40]),
        (&["--time", "0.75"], "clock.png", [191, 40]),
        (&["--frames", "3", "--fps", "8"], "clock_0003.png", [128, 42]),
    ] {
        let path = folder.path().join("clock.png").display().to_string();
        let output = orogen(&[&["render", &scene, "--size", "4x4", "-o", &path], &set[..], more].concat());
        assert_eq!(status(&output), 0, "{}", err(&output));
        let picture = image::open(folder.path().join(name)).expect("it was written").to_rgb8();
        let found = picture.get_pixel(0, 0);
        assert!((0..2).all(|i| found[i].abs_diff(expected[i]) <= 1), "{more:?}: {found:?}");
    }
}

#[test]
fn a_drag_of_the_mouse_reaches_the_scene_as_on_shadertoy() {
    let folder = folder();
    let scene = put(
        &folder,
        "mouse.wgsl",
        "#include <frame.wgsl>
fn main_image(p: vec2f) -> vec4f { return vec4f(abs(frame.mouse.xyz) / 255.0, step(0.0, -frame.mouse.w)); }\n",
    );
    let path = folder.path().join("mouse.png").display().to_string();
    for (more, expected) in [
        (&["--set", "frame.mouse=[1,2,3,4]"] as &[&str], [1, 2, 3, 0]),
        (&["--set", "frame.mouse=[1,2,3,4]", "--mouse", "-40,90,200,-7"], [40, 90, 200, 255]),
        (&["--mouse", " 10.0, 20, 30, -5 ", "--live", "*"], [10, 20, 30, 255]),
        (&["--mouse", "10,20,30,40", "--frames", "1"], [10, 20, 30, 0]),
    ] {
        let output = orogen(&[&["render", &scene, "--size", "4x4", "-o", &path], more].concat());
        assert_eq!(status(&output), 0, "{}", err(&output));
        let name = if more.contains(&"--frames") { "mouse_0001.png" } else { "mouse.png" };
        let found = picture(&folder, name).0.to_rgba8();
        let found = found.get_pixel(0, 0);
        assert!((0..4).all(|i| found[i].abs_diff(expected[i]) <= 1), "{more:?}: {found:?}");
    }
}

/// The picture of that name, and its size.
fn picture(folder: &tempfile::TempDir, name: &str) -> (image::DynamicImage, (u32, u32)) {
    let picture = image::open(folder.path().join(name)).expect("it was written");
    let size = (picture.width(), picture.height());
    (picture, size)
}

#[test]
fn a_skybox_is_one_column_of_faces_or_six_files() {
    let folder = folder();
    let sky = put(&folder, "sky.json", "{\"orogen\": 1, \"scene\": \"scene/sky.wgsl\"}");
    let run = |arguments: &[&str]| {
        let mut command = command(&[&["render", &sky, "--projection", "cube"], arguments].concat());
        let output = command.current_dir(folder.path()).output().expect("it starts");
        assert_eq!(status(&output), 0, "{}", err(&output));
        err(&output)
    };
    run(&["--size", "16x16", "-o", "sky.png"]);
    run(&["--size", "16x16", "--faces", "-o", "sky.png"]);
    let (column, size) = picture(&folder, "sky.png");
    assert_eq!(size, (16, 96));
    for (index, face) in ["px", "nx", "py", "ny", "pz", "nz"].iter().enumerate() {
        let (alone, size) = picture(&folder, &format!("sky_{face}.png"));
        assert_eq!(size, (16, 16), "{face}");
        let of_column = column.crop_imm(0, 16 * index as u32, 16, 16).to_rgb8();
        let bytes = of_column.as_raw().iter().zip(alone.to_rgb8().into_raw());
        let off = bytes.map(|(a, b)| a.abs_diff(b)).max();
        assert!(off <= Some(3), "{face} is {off:?} off but for the dither");
    }

    let told = run(&["--size", "8x8", "--faces", "--frames", "2", "--samples", "2", "-o", "skies.exr"]);
    assert!(told.contains("skies_0001_px.exr and 11 more"), "{told}"); // drivers may speak before
    let (linear, size) = picture(&folder, "skies_0002_nz.exr");
    assert_eq!((size, linear.color()), ((8, 8), image::ColorType::Rgba32F));
}

#[test]
fn a_preset_may_ask_for_everything_around() {
    let folder = folder();
    for (projection, size) in [("equirectangular", (2048, 1024)), ("cube", (512, 3072))] {
        let text = "#include <camera/camera.wgsl>\n\
                    fn main_image(p: vec2f) -> vec4f { return vec4f(abs(camera_ray(p, 0.0).direction), 1.0); }\n";
        put(&folder, "around.wgsl", text);
        let set = format!("{{\"camera\": {{\"projection\": \"{projection}\"}}}}");
        let preset = format!("{{\"orogen\": 1, \"scene\": \"around.wgsl\", \"set\": {set}}}");
        let preset = put(&folder, "around.json", &preset);
        let path = folder.path().join("around.png").display().to_string();
        let output = orogen(&["render", &preset, "-o", &path]);
        assert_eq!(status(&output), 0, "{}", err(&output));
        assert_eq!(picture(&folder, "around.png").1, size);
        let output = orogen(&["render", &preset, "--projection", "perspective", "-o", &path]);
        assert_eq!(status(&output), 0, "{}", err(&output));
        assert_eq!(picture(&folder, "around.png").1, (960, 540), "the command line has the last word");
    }
}

#[test]
fn every_scene_and_view_and_target_can_be_all_around() {
    for arguments in [
        &["export", "alpine", "--set", "camera.projection=cube", "--live", "*"] as &[&str],
        &["export", "lake", "--set", "camera.projection=equirectangular", "--target", "shadertoy"],
        &["export", "dunes", "--set", "camera.projection=cube", "--view", "steps"],
        &["export", "<scene/sky.wgsl>", "--set", "camera.projection=cube", "--target", "glsl"],
    ] {
        let output = orogen(arguments);
        assert_eq!(status(&output), 0, "{arguments:?}: {}", err(&output));
        let function =
            if arguments[3].ends_with("cube") { "cube_direction" } else { "equirectangular_direction" };
        assert!(out(&output).contains(function), "{arguments:?}");
    }
    assert!(!out(&orogen(&["export", "alpine"])).contains("cube_direction"), "what is off leaves no code");
    let folder = folder();
    let path = folder.path().join("steps.png").display().to_string();
    let arguments =
        ["render", "dunes", "--view", "steps", "--projection", "cube", "--size", "8x8", "-o", &path];
    let output = orogen(&arguments);
    assert_eq!(status(&output), 0, "{}", err(&output));
    assert_eq!(picture(&folder, "steps.png").1, (8, 48));
}

#[test]
fn the_help_of_render_teaches_skyboxes() {
    let help = out(&orogen(&["render", "--help"]));
    for word in [
        "--projection cube --faces -o sky.png",
        "Bevy",
        "three.js",
        "+X -X +Y -Y +Z -Z",
        "vec3(d.x, d.y, -d.z)",
    ] {
        assert!(help.contains(word), "{word}");
    }
}

#[test]
fn linear_pictures_leave_the_tone_map_out_where_it_can_be() {
    let folder = folder();
    let path = folder.path().join("one.exr").display().to_string();
    for declaration in ["#param display.tone_map: f32 = 1.0", "#option display.tone_map = a { a, b }"] {
        let scene = format!("{declaration}\nfn main_image(p: vec2f) -> vec4f {{ return vec4f(1.0); }}\n");
        let scene = put(&folder, "one.wgsl", &scene);
        let output = orogen(&["render", &scene, "--size", "4x4", "-o", &path]);
        assert_eq!(status(&output), 0, "{declaration}: {}", err(&output));
    }
}

#[test]
fn without_an_adapter_the_status_is_3_and_the_cure_is_told() {
    let output = command(&["eval", "1.0"])
        .env("VK_DRIVER_FILES", "/nonexistent.json")
        .env("VK_ICD_FILENAMES", "/nonexistent.json")
        .output()
        .expect("it starts");
    assert_eq!(status(&output), 3, "{}", err(&output));
    assert!(err(&output).contains("mesa-vulkan-drivers"), "{}", err(&output));
}

#[test]
fn heightmap_writes_a_tile_and_the_words_beside_it() {
    let folder = folder();
    let tile = |origin: &str, name: &str, more: &[&str]| {
        let path = folder.path().join(name).display().to_string();
        let command =
            ["heightmap", "alpine", "--origin", origin, "--size", "512.5", "--pixels", "9", "-o", &path];
        let output = orogen(&[&command as &[&str], more].concat());
        assert_eq!(status(&output), 0, "{}", err(&output));
        let about = fs::read_to_string(format!("{path}.json")).expect("it is written beside");
        let about: serde_json::Value = serde_json::from_str(&about).expect("it is JSON");
        (fs::read(path).expect("it is written"), about, err(&output))
    };
    let (west, about, said) = tile("-9570,-6988.25", "a.r16", &[]);
    let (east, beside, _) = tile("-9057.5,-6988.25", "b.r16", &["-q"]);
    assert_eq!(west.len(), 9 * 9 * 2);
    let column = |file: &[u8], index: usize| -> Vec<u8> {
        file.chunks_exact(18).flat_map(|row| row[2 * index..2 * index + 2].to_vec()).collect()
    };
    assert_eq!(column(&west, 8), column(&east, 0), "they share their border");
    assert_eq!(about["encoding"], beside["encoding"], "and what their numbers mean");
    assert_eq!((&about["origin"]["x"], &about["size"]), (&(-9570.0).into(), &512.5.into()));
    assert!(said.contains("9x9 heights every 64.0625 m") && said.contains("a.r16.json"), "{said}");

    let (png, ..) = tile("0,0", "c.png", &[]);
    assert!(png.starts_with(b"\x89PNG"));
    let (exr, about, _) = tile("0,0", "d.exr", &["--footprint", "64"]);
    assert!(exr.starts_with(&[0x76, 0x2f, 0x31, 0x01]));
    assert_eq!(about["encoding"]["type"], "f32");
    let (_, _, said) = tile("0,0", "e.png", &["--range", "-1,1", "-q"]);
    assert!(said.contains("warning: 81 of 81 heights lie outside of -1 m to 1 m"), "{said}");
}
