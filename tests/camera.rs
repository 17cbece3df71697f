//! What the mouse does: a drag turns the view of every scene as other angles in the preset would, and no drag leaves it alone.

#![cfg(feature = "render")]

use std::sync::LazyLock;

use orogen::render::{Gpu, Picture, Shot, render, srgb_encode};
use orogen::{Bake, Library, Preset, compose};

static GPU: LazyLock<Gpu> =
    LazyLock::new(|| Gpu::new(None).expect("the tests run on lavapipe: `cargo xtask test`"));

fn draw(preset: &Preset, shot: &Shot) -> Picture {
    let shader = compose(&Library::standard(), preset, &Bake::constants()).expect("it composes");
    render(&GPU, &shader, preset, shot, &mut |_, _| {}).expect("it can be drawn")
}

fn set(mut preset: Preset, assignments: &[&str]) -> Preset {
    for assignment in assignments {
        preset.set(assignment).expect("it is declared");
    }
    preset
}

// ---- the whole picture of every scene ----

const SIZE: (u32, u32) = (80, 48);
/// An eighth of the picture to the left and a sixteenth of its width down, button held: 22.5° to the right, 11.25° up.
const DRAGGED: [f32; 4] = [40.0, 15.0, 50.0, -20.0];

/// PSNR in dB, of what a display shows.
fn psnr(a: &Picture, b: &Picture) -> f64 {
    let shown = |picture: &Picture| -> Vec<f64> {
        picture
            .pixels
            .iter()
            .flat_map(|pixel| pixel.map(|c| f64::from(srgb_encode(c).clamp(0.0, 1.0))))
            .collect()
    };
    let (a, b) = (shown(a), shown(b));
    let squares: f64 = a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum();
    -10.0 * (squares / a.len() as f64).max(1e-12).log10()
}

fn a_drag_turns(preset: Preset, azimuth: f64, elevation: f64) {
    let preset = set(preset, &["quality=low", "display.dither=false"]);
    let still = Shot::new(SIZE.0, SIZE.1);
    let dragged = draw(&preset, &Shot { mouse: Some(DRAGGED), ..still });
    let (azimuth, elevation) = (azimuth + 22.5, elevation + 11.25);
    let angles = [format!("camera.azimuth={azimuth}"), format!("camera.elevation={elevation}")];
    let turned = set(preset.clone(), &angles.each_ref().map(String::as_str));
    let (as_turned, as_it_was) =
        (psnr(&dragged, &draw(&turned, &still)), psnr(&dragged, &draw(&preset, &still)));
    assert!(as_turned > 42.0, "against the angles in the preset: {as_turned:.1} dB");
    assert!(as_it_was < 30.0, "against the view before: {as_it_was:.1} dB");
}

#[test]
fn a_drag_turns_the_camera_of_a_landscape() {
    a_drag_turns(Preset::named("dunes").expect("it is built in"), 322.0, -5.0);
}

#[test]
fn a_drag_turns_the_camera_of_a_cloudscape() {
    a_drag_turns(Preset::named("flight").expect("it is built in"), 320.0, -6.0);
}

#[test]
fn a_drag_turns_the_camera_over_a_planet() {
    a_drag_turns(Preset::named("mars").expect("it is built in"), 333.0, -5.0);
}

#[test]
fn a_drag_turns_the_camera_under_a_bare_sky() {
    let sky =
        r#"{ "orogen": 1, "scene": "scene/sky.wgsl", "set": { "sun": { "azimuth": 0, "elevation": 20 } } }"#;
    a_drag_turns(Preset::parse("sky.json", sky).expect("it is a preset"), 0.0, 0.0);
}

#[test]
fn a_drag_turns_a_debug_view_along_with_its_scene() {
    let preset = Preset::named("dunes").expect("it is built in");
    let mut composer = orogen::Compose::default();
    composer.view = Some("normals".into());
    let shader = composer.run(&Library::standard(), &preset, &Bake::constants()).expect("it composes");
    let view = |mouse| {
        let shot = Shot { mouse, ..Shot::new(SIZE.0, SIZE.1) };
        render(&GPU, &shader, &preset, &shot, &mut |_, _| {}).expect("it can be drawn")
    };
    assert!(psnr(&view(None), &view(Some(DRAGGED))) < 30.0);
}

// ---- the direction in the middle of the picture ----

/// Azimuth and elevation, in degrees, of the middle of the picture.
fn looks(assignments: &[&str], mouse: Option<[f32; 4]>) -> (f64, f64) {
    let text = "#include <camera/camera.wgsl>
        #include <color/srgb.wgsl>
        fn main_image(p: vec2f) -> vec4f {
            return vec4f(srgb_encode(0.5 + 0.5 * camera_ray(0.5 * frame.resolution, 0.0).direction), 1.0);
        }";
    let preset = set(Preset::of_text("compass.wgsl", text), assignments);
    let picture = draw(&preset, &Shot { mouse, ..Shot::new(720, 4) });
    let [x, y, z] = [0, 1, 2].map(|i| f64::from(2.0 * picture.pixels[0][i] - 1.0));
    (x.atan2(-z).to_degrees(), y.clamp(-1.0, 1.0).asin().to_degrees())
}

fn are(found: (f64, f64), expected: (f64, f64)) -> bool {
    (found.0 - expected.0).abs() < 0.02 && (found.1 - expected.1).abs() < 0.02
}

const EAST: [&str; 2] = ["camera.azimuth=90", "camera.elevation=10"];

#[test]
fn without_a_drag_the_view_is_the_presets() {
    let view = looks(&EAST, None);
    assert!(are(view, (90.0, 10.0)), "{view:?}");
    // Pressed and not moved; let go again where it was pressed.
    assert_eq!(looks(&EAST, Some([300.0, 2.0, 300.0, -2.0])), view);
    assert_eq!(looks(&EAST, Some([300.0, 2.0, -300.0, -2.0])), view);
    for steep in ["camera.elevation=89", "camera.elevation=-89"] {
        let (_, elevation) = looks(&[steep], None);
        assert!((elevation.abs() - 89.0).abs() < 0.02, "{steep}: {elevation}");
    }
}

#[test]
fn the_view_turns_in_proportion_and_what_is_seen_goes_with_the_mouse() {
    for (mouse, expected) in [
        ([340.0, 2.0, 300.0, 2.0], (80.0, 10.0)), // 40 of 720 pixels, of 180°
        ([300.0, 2.0, 340.0, -2.0], (100.0, 10.0)),
        ([220.0, 62.0, -300.0, -2.0], (110.0, -5.0)), // stays when let go
    ] {
        let view = looks(&EAST, Some(mouse));
        assert!(are(view, expected), "{mouse:?}: {view:?}");
    }
    let half = looks(&[&EAST[..], &["camera.drag=90"]].concat(), Some([340.0, 2.0, 300.0, 2.0]));
    assert!(are(half, (85.0, 10.0)), "{half:?}");
    let locked = looks(&[&EAST[..], &["camera.drag=0"]].concat(), Some([340.0, 2.0, 300.0, 2.0]));
    assert!(are(locked, (90.0, 10.0)), "{locked:?}");
}

#[test]
fn a_drag_turns_away_from_the_point_that_is_looked_at() {
    let point = ["camera.aim=point", "camera.position=[0,5,0]", "camera.look_at=[1000,5,0]"];
    let view = looks(&point, Some([340.0, 22.0, 300.0, 2.0]));
    assert!(are(view, (80.0, -5.0)), "{view:?}");
}

#[test]
fn no_drag_turns_the_view_over_the_zenith() {
    for (mouse, expected) in [([300.0, -900.0, 300.0, 2.0], 89.0), ([300.0, 900.0, 300.0, 2.0], -89.0)] {
        let (azimuth, elevation) = looks(&EAST, Some(mouse));
        assert!(
            (elevation - expected).abs() < 0.02 && (azimuth - 90.0).abs() < 0.5,
            "{azimuth}, {elevation}"
        );
    }
}
