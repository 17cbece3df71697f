//! Hot reload: files in a real folder are saved as editors save them, and the shader follows.
//!
//! Times are printed, and bounded generously: machines that run tests are busy.

#![cfg(feature = "watch")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use orogen::watch::{Made, Recipe, Watch};
use orogen::{Bake, Error, Library, Preset};

/// Longer than any save takes to arrive.
const SOON: Duration = Duration::from_secs(20);
/// Long enough for what is not to arrive.
const A_WHILE: Duration = Duration::from_millis(300);

const SCENE: &str = "#include \"light.wgsl\"
#include <shared/tone.wgsl>
fn main_image(p: vec2f) -> vec4f { return vec4f(tone(light(p)), lamp.power); }
";
const LIGHT: &str = "/// How bright.
#param lamp.power: f32 = 1.0, range 0 .. 10
fn light(p: vec2f) -> vec3f { return vec3f(0.25); }
";
const TONE: &str = "fn tone(c: vec3f) -> vec3f { return c; }\n";

/// A folder with a preset that extends another, a scene, a fragment beside it, and a folder laid over the library.
struct World {
    folder: tempfile::TempDir,
}

impl World {
    fn new() -> Self {
        let world = Self { folder: tempfile::tempdir().unwrap() };
        fs::create_dir_all(world.path("over/shared")).unwrap();
        world
            .put("base.json", r#"{ "orogen": 1, "scene": "scene.wgsl", "set": { "lamp": { "power": 2 } } }"#);
        world.put("world.json", r#"{ "orogen": 1, "extends": "base.json" }"#);
        world.put("scene.wgsl", SCENE);
        world.put("light.wgsl", LIGHT);
        world.put("over/shared/tone.wgsl", TONE);
        world
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.folder.path().join(name)
    }

    /// Saves in place, as most do.
    fn put(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    /// Saves by renaming, as vim and many others do.
    fn put_by_renaming(&self, name: &str, text: &str) {
        let beside = self.path(&format!("{name}~"));
        fs::write(&beside, text).unwrap();
        fs::rename(beside, self.path(name)).unwrap();
    }

    fn watch(&self) -> Watch {
        let library = Library::standard().with_folder(self.path("over")).unwrap();
        let mut watch =
            Watch::new(Recipe::file(library, Bake::constants(), self.path("world.json"))).unwrap();
        let first = watch.next(Duration::ZERO).expect("at first there is what there is").unwrap();
        assert!(first.shader.wgsl().contains("vec3f(0.25)"));
        watch
    }
}

/// The first news that is as expected. A save in place may be heard of halfway on a busy machine: what is told of it then is
/// no fault.
fn until(watch: &mut Watch, is_it: impl Fn(&Result<Made, Error>) -> bool) -> Result<Made, Error> {
    let end = Instant::now() + SOON;
    loop {
        let news = watch.next(end.saturating_duration_since(Instant::now()));
        let news = news.expect("there is news, and in the end as expected");
        if is_it(&news) {
            return news;
        }
    }
}

/// The first shader that has `word` in it.
fn with(watch: &mut Watch, word: &str) -> Made {
    until(watch, |news| news.as_ref().is_ok_and(|made| made.shader.wgsl().contains(word))).unwrap()
}

#[test]
fn a_saved_fragment_is_in_the_next_shader() {
    let world = World::new();
    let mut watch = world.watch();
    for (round, name) in ["light.wgsl", "light.wgsl", "light.wgsl"].into_iter().enumerate() {
        let value = format!("vec3f(0.5{round})");
        let start = Instant::now();
        world.put(name, &LIGHT.replace("vec3f(0.25)", &value));
        let made = with(&mut watch, &value);
        println!("save to shader: {:?}; from the first word about it {:?}", start.elapsed(), made.took);
    }
}

#[test]
fn a_saved_preset_is_a_checked_shader_within_moments() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("dusk.json");
    let preset = |sun: u32| {
        format!(
            "{{ \"orogen\": 1, \"extends\": \"alpine\", \"set\": {{ \"sun\": {{ \"elevation\": {sun} }} }} }}"
        )
    };
    fs::write(&path, preset(9)).unwrap();
    let mut watch = Watch::new(Recipe::file(Library::standard(), Bake::constants(), &path)).unwrap();
    let mut text = watch.next(SOON).unwrap().unwrap().shader.wgsl().to_owned();
    let mut times = Vec::new();
    for sun in 10..15 {
        let start = Instant::now();
        fs::write(&path, preset(sun)).unwrap();
        let made = until(&mut watch, Result::is_ok).unwrap();
        times.push(start.elapsed());
        assert_ne!(made.shader.wgsl(), text, "another sun");
        text = made.shader.wgsl().to_owned();
    }
    times.sort();
    println!("alpine, save of a preset to a checked shader: {times:?}");
    assert!(times[0] < Duration::from_secs(3), "{times:?}");
}

#[test]
fn whatever_is_read_is_watched() {
    let world = World::new();
    let mut watch = world.watch();
    world.put("over/shared/tone.wgsl", "fn tone(c: vec3f) -> vec3f { return 2.0 * c; }\n");
    with(&mut watch, "2.0 * c");
    world.put("base.json", r#"{ "orogen": 1, "scene": "scene.wgsl", "set": { "lamp": { "power": 3 } } }"#);
    with(&mut watch, "3.0");
    world.put("scene.wgsl", &SCENE.replace("tone(light(p))", "light(p)"));
    until(&mut watch, |news| news.as_ref().is_ok_and(|made| !made.shader.wgsl().contains("fn tone")))
        .unwrap();
    world.put("world.json", r#"{ "orogen": 1, "extends": "base.json", "set": { "lamp": { "power": 7 } } }"#);
    with(&mut watch, "7.0");
    // A file of the library's, laid over anew.
    world.put("scene.wgsl", "#include <color/srgb.wgsl>\nfn main_image(p: vec2f) -> vec4f { return vec4f(srgb_encode(vec3f(0.5)), 1.0); }\n");
    world.put("base.json", r#"{ "orogen": 1, "scene": "scene.wgsl" }"#);
    world.put("world.json", r#"{ "orogen": 1, "extends": "base.json" }"#);
    with(&mut watch, "srgb_encode");
    fs::create_dir(world.path("over/color")).unwrap();
    std::thread::sleep(A_WHILE); // a new folder is watched a moment after it is made
    world.put("over/color/srgb.wgsl", "fn srgb_encode(c: vec3f) -> vec3f { return c * 0.125; }\n");
    with(&mut watch, "0.125");
}

#[test]
fn a_file_that_is_saved_by_renaming_is_still_watched() {
    let world = World::new();
    let mut watch = world.watch();
    for value in ["vec3f(0.5)", "vec3f(0.75)"] {
        world.put_by_renaming("light.wgsl", &LIGHT.replace("vec3f(0.25)", value));
        with(&mut watch, value);
    }
    world.put_by_renaming(
        "world.json",
        r#"{ "orogen": 1, "extends": "base.json", "set": { "lamp": { "power": 4 } } }"#,
    );
    with(&mut watch, "4.0");
}

#[test]
fn a_slip_is_told_once_and_so_is_its_repair() {
    let world = World::new();
    let mut watch = world.watch();
    world.put("light.wgsl", &LIGHT.replace("vec3f(0.25)", "vec3f(nothing)"));
    let is_it =
        |error: &Error| error.to_string().contains("light.wgsl:3:") && error.to_string().contains("nothing");
    assert!(until(&mut watch, |news| news.as_ref().is_err_and(is_it)).is_err());
    world.put_by_renaming("light.wgsl", &LIGHT.replace("vec3f(0.25)", "vec3f(nothing)"));
    assert!(watch.next(A_WHILE).is_none(), "the same again is no news");
    world.put("light.wgsl", LIGHT);
    with(&mut watch, "vec3f(0.25)");
}

#[test]
fn a_file_that_is_gone_is_told_and_found_again() {
    let world = World::new();
    let mut watch = world.watch();
    for name in ["light.wgsl", "base.json", "world.json"] {
        let text = fs::read_to_string(world.path(name)).unwrap();
        fs::remove_file(world.path(name)).unwrap();
        assert!(until(&mut watch, Result::is_err).is_err(), "{name} is gone");
        world.put(name, &text);
        assert!(until(&mut watch, Result::is_ok).is_ok(), "{name} is back");
    }
}

#[test]
fn what_changes_nothing_is_no_news() {
    let world = World::new();
    let mut watch = world.watch();
    world.put_by_renaming("light.wgsl", LIGHT);
    world.put("notes.txt", "buy milk");
    world.put("unread.wgsl", "fn nobody() {}\n");
    assert!(watch.next(A_WHILE).is_none());
    assert!(watch.next(Duration::ZERO).is_none(), "no time to wait: only a look");
}

#[test]
fn a_watch_goes_to_a_thread() {
    fn is_send<T: Send + 'static>() {}
    is_send::<Watch>();
    is_send::<Result<Made, Error>>();
}

#[test]
fn a_host_brings_its_own_preset() {
    let world = World::new();
    let library = Library::standard().with_folder(world.path("over")).unwrap();
    let scene = "#include <shared/tone.wgsl>\nfn main_image(p: vec2f) -> vec4f { return vec4f(tone(vec3f(1.0)), 1.0); }\n";
    let recipe = Recipe::new(library, Bake::constants(), move |_, _| Ok(Preset::of_text("host.wgsl", scene)));
    let mut watch = Watch::new(recipe).unwrap();
    assert!(watch.next(SOON).unwrap().is_ok());
    world.put("over/shared/tone.wgsl", "fn tone(c: vec3f) -> vec3f { return c / 3.0; }\n");
    with(&mut watch, "c / 3.0");
}

/// The command, on a scene of a few lines.
#[cfg(feature = "cli")]
#[test]
fn render_watch_draws_anew_and_keeps_the_last_good_picture() {
    use std::io::{BufRead, BufReader};
    use std::process::{Command, Stdio};
    use std::sync::mpsc::channel;

    let world = World::new();
    let picture = world.path("out.png");
    let mut command = Command::new(env!("CARGO_BIN_EXE_orogen"));
    command.args(["render", "--watch", "--size", "8x8", "-I"]).arg(world.path("over"));
    command.arg("-o").arg(&picture).arg(world.path("world.json"));
    let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
    let (sender, lines) = channel();
    let stderr = BufReader::new(child.stderr.take().unwrap());
    std::thread::spawn(move || stderr.lines().map_while(Result::ok).try_for_each(|line| sender.send(line)));
    let until = |word: &str| {
        let mut said = String::new();
        while !said.contains(word) {
            said += &lines.recv_timeout(SOON).unwrap_or_else(|_| panic!("no `{word}` after:\n{said}"));
            said.push('\n');
        }
        said
    };
    let colour = |path: &Path| image::open(path).unwrap().to_rgb8().get_pixel(4, 4).0[0];
    println!("{}", until("watching"));
    assert!((60..70).contains(&colour(&picture)), "a quarter of white");
    world.put("light.wgsl", &LIGHT.replace("0.25", "0.75"));
    println!("{}", until("watching"));
    assert!((187..196).contains(&colour(&picture)));
    world.put("light.wgsl", &LIGHT.replace("vec3f(0.25)", "vec3f(nothing)"));
    let said = until("stays as it was");
    assert!(said.contains("light.wgsl:3:"), "{said}");
    assert!((187..196).contains(&colour(&picture)), "the last good picture is kept");
    world.put_by_renaming("light.wgsl", LIGHT);
    until("watching");
    assert!((60..70).contains(&colour(&picture)));
    child.kill().unwrap();
    child.wait().unwrap();
}
