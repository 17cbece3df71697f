//! A frame of the engine, held against the heights of the land: who hides whom, how deep the land lies, and who is lit.
//!
//! Heights come from `terrain_height` at single points and a march of a few lines in f64: nothing here knows how the land is
//! drawn.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use embed::camera::Camera;
use embed::engine::Engine;
use embed::landscape::{self, Landscape};
use embed::shot::{self, Frame};
use embed::{tower, world};
use glam::Vec3;

const SIZE: [u32; 2] = [240, 136];

const SET: [&str; 3] = ["quality=medium", "landscape.trees=false", "weather.cirrus=false"];

/// The example's world without its woods, which heights say nothing about.
fn engine() -> Engine {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let (_, device, queue) =
        world::device(&instance, None).expect("the tests run on lavapipe: `cargo xtask test`");
    world::engine(device, queue, shot::FORMAT, &SET.map(str::to_owned), &landscape::bake()).unwrap()
}

fn draw(engine: &Engine, camera: &Camera) -> Frame {
    shot::frame(engine, camera, SIZE, 1, world::EXPOSURE).unwrap()
}

/// How far the ray from `eye` to `place` stays over the land (m), at the least; the last `margin` m left out.
fn clearance(engine: &mut Engine, eye: Vec3, place: Vec3, margin: f32) -> f32 {
    let way = place - eye;
    let steps = ((way.length() - margin) / 1.0).max(2.0);
    let along: Vec<Vec3> = (1..steps as u32).map(|step| eye + way * (step as f32 / way.length())).collect();
    let heights = engine.ground(&along.iter().map(|p| [p.x, p.z]).collect::<Vec<_>>()).unwrap();
    along.iter().zip(heights).map(|(p, height)| p.y - height).fold(f32::MAX, f32::min)
}

/// Whose the pixel is that shows `place`; none outside of the picture.
fn shown(frame: &Frame, camera: &Camera, place: Vec3) -> Option<(usize, u32)> {
    let at = camera.pixel(place, frame.size)?;
    let is_inside = at.x >= 0.0 && at.y >= 0.0 && at.x < frame.size[0] as f32 && at.y < frame.size[1] as f32;
    let index = at.y as usize * frame.size[0] as usize + at.x as usize;
    is_inside.then(|| (index, frame.things[index]))
}

/// Points up the middle of a thing.
fn axis(engine: &Engine, thing: usize) -> Vec<Vec3> {
    let thing = &engine.things[thing];
    let heights = (1..30).map(|i| thing.scale * tower::HEIGHT * i as f32 / 31.0);
    heights.map(|height| thing.foot + height * Vec3::Y).collect()
}

#[test]
fn a_near_tower_hides_far_hills() {
    let mut engine = engine();
    let camera = world::camera(&mut engine).unwrap();
    let frame = draw(&engine, &camera);
    let mut before_land = 0;
    // Its lowest parts stand behind the swell of the meadow before it, or not: heights a step apart can't tell.
    for place in axis(&engine, 0).into_iter().skip(6) {
        assert!(clearance(&mut engine, camera.eye, place, 6.0) > 1.0, "nothing stands before it");
        let (_, thing) = shown(&frame, &camera, place).expect("it is in the picture");
        assert_eq!(thing, 1, "the tower at {place}");
        // The same ray goes on into the land, kilometres behind.
        let beyond = camera.eye + 150.0 * (place - camera.eye);
        before_land += u32::from(clearance(&mut engine, camera.eye, beyond, 0.0) < -5.0);
    }
    assert!(before_land >= 10, "{before_land} of 23 points stand before hills");
}

#[test]
fn a_near_hill_hides_a_far_tower_up_to_its_edge() {
    let mut engine = engine();
    // Behind the crest of the hill on the right: its foot is hidden, its head is not.
    engine.stand(1, [-9742.0, -8133.0], 0.0, 2.0).unwrap();
    let eye = world::camera(&mut engine).unwrap().eye;
    let middle = engine.things[1].foot + 15.0 * Vec3::Y;
    let camera = Camera::looking_at(eye, middle, 180.0);
    let frame = draw(&engine, &camera);
    let (mut hidden, mut seen) = (0, 0);
    for place in axis(&engine, 1) {
        let clear = clearance(&mut engine, camera.eye, place, 14.0);
        let (_, thing) = shown(&frame, &camera, place).expect("it is in the picture");
        if clear < -1.5 {
            assert_eq!(thing, 0, "{place} is {clear} m under the hill's edge");
            hidden += 1;
        } else if clear > 1.5 {
            assert_eq!(thing, 2, "{place} is {clear} m over the hill's edge");
            seen += 1;
        }
    }
    assert!(hidden >= 4 && seen >= 4, "{hidden} points hidden, {seen} seen");
}

#[test]
fn the_land_is_as_deep_as_it_lies() {
    let mut engine = engine();
    let camera = world::camera(&mut engine).unwrap();
    let frame = draw(&engine, &camera);
    let [width, height] = frame.size.map(|side| side as f32);
    let back = camera.clip_from_eye(width / height).1;
    let mut places = Vec::new();
    let mut sky = 0;
    for (index, depth) in frame.depth.iter().enumerate() {
        let (x, y) = (index as u32 % frame.size[0], index as u32 / frame.size[0]);
        if frame.things[index] != 0 || !(x + y).is_multiple_of(7) {
            continue;
        }
        if *depth < 1e-9 {
            sky += 1;
            continue;
        }
        let clip = [2.0 * (x as f32 + 0.5) / width - 1.0, 1.0 - 2.0 * (y as f32 + 0.5) / height];
        places.push(camera.eye + back.project_point3(Vec3::new(clip[0], clip[1], *depth)));
    }
    let heights = engine.ground(&places.iter().map(|p| [p.x, p.z]).collect::<Vec<_>>()).unwrap();
    // What is left out of the far land is too small to be seen in a pixel: that is the measure.
    let pixel = 36.0 / camera.focal_length / width;
    let off =
        |(place, height): (&Vec3, &f32)| (place.y - height).abs() / (pixel * (*place - camera.eye).length());
    let mut errors: Vec<f32> = places.iter().zip(&heights).map(off).collect();
    errors.sort_by(f32::total_cmp);
    let [half, most] = [errors[errors.len() / 2], errors[errors.len() * 98 / 100]];
    println!(
        "{} pixels of land, {sky} of sky: off by {half:.3} pixels (median), {most:.3} (98 %)",
        errors.len()
    );
    assert!(errors.len() > 1000 && sky > 500);
    assert!(half < 1.0 && most < 3.0, "off by {half} pixels, 98 % within {most}");
}

/// Mean brightness (0 .. 255, green) of the pixels that show thing 0.
fn brightness(frame: &Frame) -> f32 {
    let of_it = frame.things.iter().zip(frame.display.chunks_exact(4)).filter(|(thing, _)| **thing == 1);
    let greens: Vec<f32> = of_it.map(|(_, pixel)| f32::from(pixel[1])).collect();
    assert!(greens.len() > 200, "{} pixels show it", greens.len());
    greens.iter().sum::<f32>() / greens.len() as f32
}

#[test]
fn a_tower_in_the_shade_of_a_mountain_is_dark() {
    let mut engine = engine();
    let camera = world::camera(&mut engine).unwrap();
    let foot = engine.things[0].foot;
    let sunlit = brightness(&draw(&engine, &camera));
    // The nearest place whose way to the sun goes deep through the land.
    let to_sun = engine.to_sun();
    let shady = (1..200)
        .map(|step| foot + Vec3::new(-to_sun.z, 0.0, to_sun.x).normalize() * 25.0 * step as f32)
        .find_map(|place| {
            let ground = engine.ground(&[[place.x, place.z]]).unwrap()[0];
            let place = Vec3::new(place.x, ground + 20.0, place.z);
            (clearance(&mut engine, place, place + 6000.0 * to_sun, 0.0) < -40.0).then_some(place)
        });
    let place = shady.expect("there are mountains, and the sun is low");
    engine.stand(0, [place.x, place.z], 20_f32.to_radians(), 1.0).unwrap();
    let there = engine.things[0].foot;
    let ground = engine.ground(&[[there.x + 40.0, there.z + 60.0]]).unwrap()[0];
    let eye = Vec3::new(there.x + 40.0, ground.max(there.y) + 12.0, there.z + 60.0);
    let shaded = brightness(&draw(&engine, &Camera::looking_at(eye, there + 8.0 * Vec3::Y, 35.0)));
    assert!(shaded < 0.75 * sunlit, "{shaded} in the shade, {sunlit} in the sun");
    assert!(shaded > 8.0, "the sky lights it: {shaded}");
}

#[test]
fn a_tower_throws_its_shadow_on_the_land() {
    let mut engine = engine();
    let camera = world::camera(&mut engine).unwrap();
    let foot = engine.things[0].foot;
    let away = Vec3::new(-engine.to_sun().x, 0.0, -engine.to_sun().z).normalize();
    let with = draw(&engine, &camera);
    engine.stand(0, [foot.x + 3000.0, foot.z], 0.0, 1.0).unwrap();
    let without = draw(&engine, &camera);
    let mut ratios = Vec::new();
    for step in 0..8 {
        let place = foot + (6.0 + step as f32) * away;
        let ground = engine.ground(&[[place.x, place.z]]).unwrap()[0];
        let (index, thing) = shown(&with, &camera, Vec3::new(place.x, ground, place.z)).unwrap();
        if thing == 0 {
            let green = |frame: &Frame| f32::from(frame.display[4 * index + 1]);
            ratios.push(green(&with) / green(&without));
        }
    }
    let mean = ratios.iter().sum::<f32>() / ratios.len() as f32;
    assert!(ratios.len() >= 3, "{} places beside the tower are seen", ratios.len());
    assert!(mean < 0.75, "the shadow is {mean} of what the ground was");
}

#[test]
fn a_shader_that_does_not_fit_leaves_the_picture_as_it_was() {
    let mut engine = engine();
    let camera = world::camera(&mut engine).unwrap();
    let before = draw(&engine, &camera).display;
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/wgsl/world.wgsl")).unwrap();
    let with = |from: &str, to: &str, engine: &Engine| {
        assert!(text.contains(from));
        let library = landscape::library().unwrap().with_file("world.wgsl", text.replace(from, to));
        let preset = world::preset(&SET.map(str::to_owned)).unwrap();
        let shader = orogen::compose(&library, &preset, &landscape::bake()).unwrap();
        Landscape::new(&engine.device, shader, preset)
    };
    let misfit = with("fn thing_fragment", "fn thing_fragmant", &engine);
    let error = engine.set_landscape(misfit).unwrap_err().to_string();
    assert!(error.contains("thing_fragment"), "{error}");
    assert!(draw(&engine, &camera).display == before);
    let darker = with("vec4f(seen.radiance, 1.0)", "vec4f(0.5 * seen.radiance, 1.0)", &engine);
    engine.set_landscape(darker).unwrap();
    assert!(draw(&engine, &camera).display != before);
}

#[test]
fn another_value_of_a_live_parameter_is_drawn_by_the_shader_that_is_there() {
    let mut engine = engine();
    let camera = world::camera(&mut engine).unwrap();
    let before = draw(&engine, &camera).display;
    let made = |set: &str| {
        let preset = world::preset(
            &[&SET[..], &[set]].concat().iter().map(|set| (*set).to_owned()).collect::<Vec<_>>(),
        )
        .unwrap();
        let library = landscape::library().unwrap();
        (orogen::compose(&library, &preset, &landscape::bake()).unwrap(), preset)
    };
    let (shader, preset) = made("terrain.peak_height=1500"); // baked in
    assert!(!engine.retune(&shader, &preset));
    assert!(draw(&engine, &camera).display == before);
    let (shader, preset) = made("sun.azimuth=80");
    assert!(engine.retune(&shader, &preset));
    assert!(draw(&engine, &camera).display != before);
    let sun = engine.to_sun();
    engine.settle().unwrap();
    assert!(engine.to_sun().dot(sun) < 0.99, "the sun is elsewhere");
}

#[test]
fn the_readme_shows_the_integration_as_it_is() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let readme = std::fs::read_to_string(format!("{root}/README.md")).unwrap();
    let integration = include_str!("../src/landscape.rs");
    let (_, code) = integration.split_once("\n\n").expect("a line about the file, and the code");
    assert!(readme.contains(code.trim_end()), "README.md has another src/landscape.rs");
    assert!(integration.lines().count() < 60, "the integration is short");
}
