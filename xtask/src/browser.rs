//! The browser as a judge: what Chromium draws of the exported files, held against what `orogen render` draws.
//!
//! Every preset's Shadertoy file through WebGL2, in what Shadertoy puts around it; some presets as plain GLSL with their
//! parameters in a uniform block, and as WGSL through WebGPU. Same size, time and mouse; what differs is the compiler and the
//! driver, and the pictures must not.

use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use crate::cases::{CONST, UNIFORM};
use crate::install;
use crate::pictures::{Psnr, bare, psnr, shown, write_png};
use crate::run::{
    Failure, Outcome, capture, command, create_folder, in_parallel, read, run, tested_orogen, write,
};

const SIZE: (u32, u32) = (320, 180);

/// A frame that is drawn on both sides.
struct Moment {
    name: &'static str,
    time: f32,
    /// Number of the frame, at 60 a second.
    index: u32,
    /// As Shadertoy's iMouse, in pixels.
    mouse: [f32; 4],
}

impl Moment {
    /// What makes `orogen` draw it, less `-o`: `render` leaves dither and tone map out of EXR unless told.
    fn render(&self, preset: &str, tone_map: &str) -> Vec<String> {
        let Self { time, index, mouse, .. } = self;
        let mouse = mouse.map(|pixels| pixels.to_string()).join(",");
        let (width, height) = SIZE;
        let words = format!(
            "render {preset} --quiet --size {width}x{height} --time {time} --mouse {mouse} --set frame.index={index} \
             --set display.tone_map={tone_map} --set display.dither=true"
        );
        words.split(' ').map(str::to_owned).collect()
    }
}

const MOMENTS: [Moment; 3] = [
    Moment { name: "at 0 s", time: 0.0, index: 0, mouse: [0.0; 4] },
    Moment { name: "at 7.5 s", time: 7.5, index: 450, mouse: [0.0; 4] },
    // Pressed in the middle and held, an eighth of the picture to the right and somewhat up: not so that a row of pixels lies
    // on the horizon of a sea to the last bit, where the sign of a rounding error says whether it is sky or water.
    Moment { name: "dragged", time: 0.0, index: 0, mouse: [200.0, 97.0, 160.0, -90.0] },
];
const DRAGGED: &[usize] = &[2];
const ALL: &[usize] = &[0, 1, 2];

/// How a shader gets into the browser.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Road {
    Shadertoy,
    /// GLSL ES 3.00 with every parameter in a uniform block.
    Glsl,
    WebGpu,
}

impl Road {
    fn name(self) -> &'static str {
        match self {
            Self::Shadertoy => "Shadertoy",
            Self::Glsl => "GLSL",
            Self::WebGpu => "WebGPU",
        }
    }

    /// How alike the pictures must be, in dB.
    fn bar(self) -> Psnr {
        // WebGPU's driver is SwiftShader, whose functions are less exact than Mesa's.
        Psnr(if self == Self::WebGpu { 40.0 } else { 45.0 })
    }
}

/// One shader to be drawn in the browser.
struct Subject<'a> {
    preset: &'a str,
    road: Road,
    /// Which of `MOMENTS`.
    moments: &'static [usize],
    /// Milliseconds within which it is to compile.
    limit: Option<f64>,
}

/// Presets that go every road: one of each kind of scene.
const EVERY_ROAD: [&str; 3] = ["alpine", "flight", "earth"];
/// What the Shadertoy file of `alpine` is promised to take to compile (ms).
const ALPINE_PROMISE: f64 = 2000.0;
/// How many times that fails: one and the same file took from 1.4 to 2.6 s on machines that judge. What is over the promise is
/// said in any case.
const ALPINE_SLACK: f64 = 2.0;
const ALPINE_LIMIT: f64 = ALPINE_SLACK * ALPINE_PROMISE;

/// What the browser draws of `presets`.
fn subjects<'a>(presets: &[&'a str]) -> Vec<Subject<'a>> {
    let shadertoy = presets.iter().map(|&preset| Subject {
        preset,
        road: Road::Shadertoy,
        moments: ALL,
        limit: (preset == "alpine").then_some(ALPINE_LIMIT),
    });
    let others = [Road::Glsl, Road::WebGpu].into_iter().flat_map(|road| {
        let chosen = presets.iter().filter(|preset| EVERY_ROAD.contains(preset));
        chosen.map(move |&preset| Subject { preset, road, moments: DRAGGED, limit: None })
    });
    shadertoy.chain(others).collect()
}

impl Subject<'_> {
    fn name(&self) -> String {
        format!("{}.{}", self.preset, self.road.name().to_lowercase())
    }

    /// The file among all that are judged.
    fn file(&self) -> String {
        let end = match self.road {
            Road::Shadertoy => "shadertoy.page.frag",
            Road::Glsl => "uniform.frag",
            Road::WebGpu => "fragment.const.wgsl",
        };
        format!("{}.{end}", self.preset)
    }

    /// What makes `orogen` write the file's interface; Shadertoy's is the page's.
    fn interface(&self) -> Option<Vec<&str>> {
        let live: &[&str] = match self.road {
            Road::Shadertoy => return None,
            Road::Glsl => UNIFORM.1,
            Road::WebGpu => CONST.1,
        };
        Some([&["export", self.preset, "--target", "json"], live].concat())
    }

    /// What `browser.mjs` is told.
    fn job(&self, judged: &Path, interface: Option<&Path>) -> Json {
        let shot = |&moment: &usize| {
            let Moment { time, index, mouse, .. } = &MOMENTS[moment];
            json!({ "time": time, "delta": 1.0 / 60.0, "index": index, "mouse": mouse })
        };
        json!({
            "name": self.name(),
            "api": if self.road == Road::WebGpu { "webgpu" } else { "webgl2" },
            "shader": judged.join(self.file()),
            "interface": interface,
            "shots": self.moments.iter().map(shot).collect::<Vec<_>>(),
            "limit": self.limit,
        })
    }
}

/// Draws `presets`, whose files lie in `judged`, here and in the browser, and compares. Says how each did and gives the
/// complaints; pictures of both sides lie in `folder` then.
pub(crate) fn judge(presets: &[&str], judged: &Path, folder: &Path) -> Outcome<Vec<String>> {
    create_folder(folder)?;
    references(presets, folder)?;
    let subjects = subjects(presets);
    let jobs = subjects.iter().map(|subject| {
        let interface = subject.interface().map(|words| {
            let file = folder.join(format!("{}.json", subject.name()));
            capture(tested_orogen(&words)?.arg("-o").arg(&file)).map(|_| file)
        });
        Ok(subject.job(judged, interface.transpose()?.as_deref()))
    });
    let jobs = json!({ "width": SIZE.0, "height": SIZE.1, "jobs": jobs.collect::<Outcome<Vec<_>>>()? });
    let list = folder.join("jobs.json");
    write(&list, &jobs.to_string())?;
    let mut node = command("node", &["tests/judges/browser.mjs"]);
    node.arg(&list).arg(folder);
    if let Some(chromium) = install::browser() {
        node.env("CHROMIUM", chromium);
    }
    // What the browser refuses stands in the results too; where there are none, it did not even start.
    let drawn = run(&mut node);
    let results = folder.join("results.json");
    if !results.is_file() {
        drawn?;
    }
    let results: Json = serde_json::from_str(&read(&results)?)
        .map_err(|why| Failure::Check(format!("{}: {why}", results.display())))?;

    println!("\n{}", Row::HEADER);
    let mut complaints = Vec::new();
    for subject in &subjects {
        let result = results.as_array().and_then(|all| all.iter().find(|one| one["name"] == subject.name()));
        let row = Row::of(subject, result.unwrap_or(&Json::Null), folder)?;
        println!("{row}");
        complaints.extend(row.complaints());
    }
    println!("pictures of both sides lie in {}\n", folder.display());
    Ok(complaints)
}

/// How a subject did.
struct Row<'a> {
    subject: &'a Subject<'a>,
    /// Milliseconds, or what the browser said against it.
    compiled: Result<f64, String>,
    /// For each of `MOMENTS`, if it was drawn.
    alike: [Option<Psnr>; MOMENTS.len()],
}

impl<'a> Row<'a> {
    const HEADER: &'static str =
        "preset              road       compile ms     at 0 s   at 7.5 s    dragged      worst";

    /// Compares the pictures, and writes them for people.
    fn of(subject: &'a Subject<'a>, result: &Json, folder: &Path) -> Outcome<Self> {
        let compiled = match (result["compile"].as_f64(), result["error"].as_str()) {
            (Some(milliseconds), None) => Ok(milliseconds),
            (_, error) => Err(error.unwrap_or("not drawn").to_owned()),
        };
        let mut alike = [None; MOMENTS.len()];
        if compiled.is_ok() {
            for (number, &moment) in subject.moments.iter().enumerate() {
                let name = format!("{}.{number}", subject.name());
                let theirs = bare(&folder.join(format!("{name}.rgba")))?;
                let ours = shown(&reference(folder, subject.preset, moment))?;
                write_png(&folder.join(format!("{name}.browser.png")), &theirs, SIZE)?;
                write_png(&folder.join(format!("{name}.render.png")), &ours, SIZE)?;
                alike[moment] = psnr(&theirs, &ours);
            }
        }
        Ok(Self { subject, compiled, alike })
    }

    fn worst(&self) -> Option<Psnr> {
        self.alike.iter().flatten().copied().reduce(|a, b| if b < a { b } else { a })
    }

    fn complaints(&self) -> Vec<String> {
        let Subject { preset, road, limit, .. } = self.subject;
        let what = format!("{preset} ({})", road.name());
        let milliseconds = match &self.compiled {
            Ok(milliseconds) => *milliseconds,
            Err(why) => return vec![format!("{what} in the browser: {why}")],
        };
        let too_slow = limit.filter(|limit| milliseconds > *limit);
        let too_slow =
            too_slow.map(|limit| format!("{what} takes {milliseconds:.0} ms to compile, over {limit:.0}"));
        let bar = road.bar();
        let unlike = self.subject.moments.iter().filter_map(|&moment| match self.alike[moment] {
            Some(psnr) if psnr >= bar => None,
            Some(psnr) => {
                Some(format!("{what} {} is another picture in the browser: {psnr}", MOMENTS[moment].name))
            }
            None => Some(format!("{what} {} has another size in the browser", MOMENTS[moment].name)),
        });
        too_slow.into_iter().chain(unlike).collect()
    }
}

impl std::fmt::Display for Row<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let compiled = self.compiled.as_ref().map_or("-".to_owned(), |ms| format!("{ms:.0}"));
        write!(f, "{:<19} {:<10} {compiled:>10}", self.subject.preset, self.subject.road.name())?;
        for psnr in self.alike.into_iter().chain([self.worst()]) {
            write!(f, " {:>10}", psnr.map_or("-".to_owned(), |psnr| psnr.to_string()))?;
        }
        let promised = self.subject.limit.map(|limit| limit / ALPINE_SLACK);
        match (&self.compiled, promised) {
            _ if !self.complaints().is_empty() => f.write_str("  FAILS"),
            (Ok(took), Some(promised)) if *took > promised => {
                write!(f, "  over the {promised:.0} ms promised")
            }
            _ => Ok(()),
        }
    }
}

/// The picture that `orogen render` makes of a moment: linear light, unrounded.
fn reference(folder: &Path, preset: &str, moment: usize) -> PathBuf {
    folder.join(format!("{preset}.{moment}.exr"))
}

/// Draws `presets` at all moments with `orogen render`: half of it is compiling on one core.
fn references(presets: &[&str], folder: &Path) -> Outcome {
    println!("drawing {} pictures with `orogen render`", presets.len() * MOMENTS.len());
    in_parallel(presets, |preset| draw(preset, folder)).into_iter().collect()
}

/// Draws what the exported file draws, with its tone map and its dither, into files that add nothing of their own.
fn draw(preset: &str, folder: &Path) -> Outcome {
    let tone_map = tone_map(&capture(&mut tested_orogen(&["export", preset, "--target", "json"])?)?)?;
    for (number, moment) in MOMENTS.iter().enumerate() {
        let mut render = tested_orogen(&[])?;
        render.args(moment.render(preset, &tone_map)).arg("-o").arg(reference(folder, preset, number));
        render.envs(install::driver_for_tests());
        capture(&mut render)?;
    }
    Ok(())
}

/// The tone map in an interface as JSON.
fn tone_map(interface: &str) -> Outcome<String> {
    let interface: Json = serde_json::from_str(interface)
        .map_err(|why| Failure::Check(format!("the interface is no JSON: {why}")))?;
    let tone_map = interface["options"]["display.tone_map"].as_str();
    tone_map
        .map(str::to_owned)
        .ok_or_else(|| Failure::Check("the interface tells no display.tone_map".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALPINE: Subject<'_> =
        Subject { preset: "alpine", road: Road::Shadertoy, moments: ALL, limit: Some(ALPINE_LIMIT) };

    fn row(compiled: Result<f64, String>, alike: [Option<f64>; 3]) -> Row<'static> {
        Row { subject: &ALPINE, compiled, alike: alike.map(|one| one.map(Psnr)) }
    }

    #[test]
    fn every_preset_goes_to_shadertoy_and_one_of_each_scene_everywhere() {
        let subjects = subjects(&["dunes", "earth", "alpine"]);
        let names: Vec<String> = subjects.iter().map(Subject::name).collect();
        let expected =
            ["dunes.shadertoy", "earth.shadertoy", "alpine.shadertoy", "earth.glsl", "alpine.glsl"];
        assert_eq!(names[..5], expected);
        assert_eq!(names[5..], ["earth.webgpu", "alpine.webgpu"]);
        assert_eq!(subjects.iter().filter(|subject| subject.limit.is_some()).count(), 1);
    }

    #[test]
    fn the_browser_gets_the_files_that_were_judged_and_what_is_bound_to_them() {
        let subject = Subject { preset: "earth", road: Road::Glsl, moments: DRAGGED, limit: None };
        let job = subject.job(Path::new("judged"), Some(Path::new("earth.json")));
        assert_eq!(job["shader"], "judged/earth.uniform.frag");
        assert_eq!(job["interface"], "earth.json");
        assert_eq!(job["shots"][0]["mouse"], json!([200.0, 97.0, 160.0, -90.0]));
        assert_eq!(subject.interface().expect("it has one")[4..], ["--live", "*"]);
        assert_eq!(ALPINE.interface(), None);
    }

    #[test]
    fn both_sides_draw_the_same_frame() {
        let words = MOMENTS[1].render("dunes", "agx").join(" ");
        assert!(words.contains("--time 7.5 --mouse 0,0,0,0 --set frame.index=450"), "{words}");
        assert!(words.contains("--set display.tone_map=agx --set display.dither=true"), "{words}");
    }

    #[test]
    fn the_tone_map_is_the_interfaces() {
        assert_eq!(tone_map(r#"{"options": {"display.tone_map": "agx"}}"#).expect("it is told"), "agx");
        assert!(tone_map("{}").is_err() && tone_map("agx").is_err());
    }

    #[test]
    fn a_row_shows_each_moment_and_the_worst() {
        let good = row(Ok(812.4), [Some(60.0), Some(52.34), Some(f64::INFINITY)]);
        assert_eq!(good.complaints(), <[String; 0]>::default());
        let text = "alpine              Shadertoy         812    60.0 dB    52.3 dB      equal    52.3 dB";
        assert_eq!(good.to_string(), text);
    }

    #[test]
    fn all_that_is_wrong_is_told() {
        let slow_and_unlike = row(Ok(4001.0), [Some(60.0), Some(44.9), None]);
        let complaints = slow_and_unlike.complaints();
        assert_eq!(complaints.len(), 3, "{complaints:?}");
        assert!(complaints[0].contains("4001 ms") && complaints[1].contains("at 7.5 s"), "{complaints:?}");
        assert!(slow_and_unlike.to_string().ends_with("FAILS"));
        let slow = row(Ok(2001.0), [Some(60.0); 3]);
        assert!(slow.to_string().ends_with("over the 2000 ms promised") && slow.complaints().is_empty());
        let refused = row(Err("ERROR: 0:4: 'nope' : undeclared identifier".into()), [None; 3]);
        assert_eq!(refused.complaints().len(), 1);
        assert!(refused.complaints()[0].contains("'nope'"));
    }
}
