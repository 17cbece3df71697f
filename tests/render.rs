//! Pictures: the same in every baking, whatever the tiles; averaged over samples; dithered without a bias; and an error
//! that says what to do for everything that cannot be drawn.
//!
//! `UPDATE=1 cargo test --test render` writes the expected error texts anew; `tests/golden.rs` has the presets' pictures.

#![cfg(feature = "render")]

use std::path::Path;
use std::sync::LazyLock;

use orogen::render::{
    Format, Gpu, Picture, Projection, Shot, encode, faces, is_no_adapter, jitter, render, srgb_encode,
    to_srgb8,
};
use orogen::{Bake, Compose, Error, Library, Preset, Shader, compose};

/// One for all tests: opening a device takes longer than a small picture.
static GPU: LazyLock<Gpu> =
    LazyLock::new(|| Gpu::new(None).expect("the tests run on lavapipe: `cargo xtask test`"));

const SIZE: (u32, u32) = (256, 144);

fn shader(preset: &Preset, bake: &Bake) -> Shader {
    compose(&Library::standard(), preset, bake).expect("it composes")
}

fn draw(preset: &Preset, bake: &Bake, shot: &Shot) -> Picture {
    render(&GPU, &shader(preset, bake), preset, shot, &mut |_, _| {}).expect("it can be drawn")
}

/// A scene of a few lines.
fn scene(main_image: &str) -> Preset {
    Preset::of_text(
        "scene.wgsl",
        &format!("#include <frame.wgsl>\nfn main_image(p: vec2f) -> vec4f {{ {main_image} }}"),
    )
}

fn refusal(preset: &Preset, shot: &Shot) -> Error {
    let shader =
        Compose::default().run(&Library::standard(), preset, &Bake::constants()).expect("it composes");
    render(&GPU, &shader, preset, shot, &mut |_, _| {}).expect_err("it cannot be drawn")
}

/// Holds `text` against the file of that name.
fn expect_text(name: &str, text: &str) {
    let path = Path::new("tests/render").join(name);
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, text).expect("the folder is there");
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(text, expected, "{} differs; UPDATE=1 writes it anew", path.display());
}

// ---- the same picture in every baking ----

#[test]
fn alpine_is_the_same_picture_in_every_baking() {
    every_baking("alpine");
}

#[test]
fn canyon_is_the_same_picture_in_every_baking() {
    every_baking("canyon");
}

#[test]
fn dunes_is_the_same_picture_in_every_baking() {
    every_baking("dunes");
}

fn every_baking(name: &str) {
    let mut preset = Preset::named(name).expect("it is built in");
    preset.set("quality=low").expect("every element reads it"); // the same code, fewer steps
    let shot = Shot::new(SIZE.0, SIZE.1);
    let constant = draw(&preset, &Bake::constants(), &shot);
    let bakings = [
        ("overrides", Bake::constants().with_overrides(["*"])),
        ("uniform", Bake::live(["*"])),
        ("mixed", Bake::live(["sun.*"]).with_overrides(["terrain.*"])),
    ];
    for (baking, bake) in bakings {
        let other = draw(&preset, &bake, &shot);
        let (close, psnr) = compare(&constant, &other);
        assert!(
            close >= 0.999,
            "{name}, {baking}: only {:.3} % of the pixels are within 1/255",
            100.0 * close
        );
        assert!(psnr >= 50.0, "{name}, {baking}: PSNR {psnr:.1} dB");
    }
}

/// The fraction of pixels within 1/255, and the PSNR in dB, both sRGB-encoded.
fn compare(a: &Picture, b: &Picture) -> (f64, f64) {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let (mut close, mut squares) = (0, 0.0);
    for (a, b) in a.pixels.iter().zip(&b.pixels) {
        let error = |i: usize| f64::from(encoded(a[i]) - encoded(b[i]));
        let errors = [error(0), error(1), error(2)];
        close += usize::from(errors.iter().all(|error| error.abs() <= 1.0 / 255.0));
        squares += errors.iter().map(|error| error * error).sum::<f64>();
    }
    let count = a.pixels.len() as f64;
    (close as f64 / count, -10.0 * (squares / (3.0 * count)).max(1e-20).log10())
}

fn encoded(linear: f32) -> f32 {
    srgb_encode(linear).clamp(0.0, 1.0)
}

// ---- tiles, samples, frames ----

#[test]
fn the_size_of_the_tiles_makes_no_difference() {
    let mut preset = Preset::named("alpine").expect("it is built in");
    preset.set("quality=low").expect("it is an option");
    let [small, large] = [64, 256].map(|tile| {
        let shot = Shot { samples: 2, tile: Some(tile), ..Shot::new(200, 100) };
        draw(&preset, &Bake::constants(), &shot)
    });
    assert_eq!(small, large);
}

#[test]
fn progress_counts_every_tile_of_every_sample() {
    let preset = scene("return vec4f(p.x + frame.jitter.x);");
    let shader = shader(&preset, &Bake::constants());
    let shot = Shot { samples: 3, tile: Some(16), ..Shot::new(40, 20) };
    let mut seen = Vec::new();
    render(&GPU, &shader, &preset, &shot, &mut |done, total| seen.push((done, total)))
        .expect("it can be drawn");
    assert_eq!(seen, (1..=18).map(|done| (done, 18)).collect::<Vec<_>>()); // 3 × 2 tiles, 3 samples
}

#[test]
fn samples_are_averaged_in_linear_light() {
    // An edge down the middle of pixel 4, which covers half of it.
    let preset = scene("return vec4f(vec3f(step(4.5, p.x)), 1.0);");
    let once = draw(&preset, &Bake::constants(), &Shot::new(9, 2));
    let often = draw(&preset, &Bake::constants(), &Shot { samples: 64, ..Shot::new(9, 2) });
    for (index, pixel) in often.pixels.iter().enumerate() {
        let x = index % 9;
        let expected = if x < 4 {
            0.0
        } else if x > 4 {
            1.0
        } else {
            0.5
        };
        assert!((pixel[0] - expected).abs() < 0.02, "pixel {x} is {}", pixel[0]);
        assert_eq!(pixel[3], 1.0);
    }
    assert_eq!(once.pixels[4][0], 1.0); // its centre is on the bright side
}

#[test]
fn samples_cover_the_pixel_evenly_from_its_centre_on() {
    assert_eq!(jitter(0), [0.0, 0.0]);
    let mut cells = [0; 16];
    for index in 0..256 {
        let [x, y] = jitter(index);
        assert!((-0.5..0.5).contains(&x) && (-0.5..0.5).contains(&y));
        cells[((x + 0.5) * 4.0) as usize + 4 * ((y + 0.5) * 4.0) as usize] += 1;
    }
    assert!(cells.iter().all(|count| (13..=19).contains(count)), "{cells:?}");
}

#[test]
fn a_shader_that_reads_no_jitter_is_drawn_once() {
    let text = "@fragment fn picture(@builtin(position) p: vec4f) -> @location(0) vec4f { return vec4f(p.xy, 0.0, 1.0); }";
    let preset = Preset::of_text("own.wgsl", text);
    let shader = shader(&preset, &Bake::constants());
    let mut calls = 0;
    let shot = Shot { samples: 50, ..Shot::new(8, 8) };
    let picture = render(&GPU, &shader, &preset, &shot, &mut |_, _| calls += 1).expect("it can be drawn");
    assert_eq!(calls, 1);
    assert!((srgb_encode(picture.pixels[8 * 2 + 3][0]) - 3.5).abs() < 1e-4, "rows are from the top, decoded");
    assert!((srgb_encode(picture.pixels[8 * 2 + 3][1]) - 2.5).abs() < 1e-4);
}

#[test]
fn the_frame_is_the_shots_and_the_rest_the_presets() {
    let mut preset = Preset::of_text(
        "scene.wgsl",
        "#include <frame.wgsl>
         #param tint.red: f32 = 0.25
         fn main_image(p: vec2f) -> vec4f {
             return vec4f(tint.red, frame.time, f32(frame.index) + frame.delta, frame.resolution.x + frame.mouse.x);
         }",
    );
    preset.set("frame.mouse=[100,0,0,0]").expect("it is a parameter");
    preset.set("frame.time=99").expect("it is a parameter");
    preset.set("tint.red=0.5").expect("it is a parameter");
    for bake in [Bake::constants(), Bake::live(["*"]), Bake::live(["*"]).at_binding(2, 5)] {
        let shot = Shot { time: 0.75, delta: Some(0.25), index: 3, ..Shot::new(16, 4) };
        let picture = draw(&preset, &bake, &shot);
        let [red, green, blue, alpha] = picture.pixels[0];
        assert!((srgb_encode(red) - 0.5).abs() < 1e-5);
        assert!((srgb_encode(green) - 0.75).abs() < 1e-5);
        assert!((srgb_encode(blue) - 3.25).abs() < 1e-5);
        assert_eq!(alpha, 116.0);
    }
}

#[test]
fn a_vertex_entry_point_of_the_users_own_is_drawn_with() {
    let text = "
        struct Out { @builtin(position) at: vec4f, @location(0) uv: vec2f }
        @vertex fn corner(@builtin(vertex_index) i: u32) -> Out {
            let corner = vec2f(f32(i & 1u), f32(i >> 1u));
            return Out(vec4f(corner * 4.0 - 1.0, 0.0, 1.0), corner * 2.0);
        }
        @fragment fn picture(in: Out) -> @location(0) vec4f { return vec4f(in.uv, 0.0, 1.0); }";
    let picture = draw(&Preset::of_text("own.wgsl", text), &Bake::constants(), &Shot::new(4, 4));
    let [u, v, ..] = picture.pixels[0];
    assert!((srgb_encode(u) - 0.125).abs() < 1e-4 && (srgb_encode(v) - 0.875).abs() < 1e-4);
}

#[test]
fn one_gpu_serves_many_threads() {
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4)
            .map(|i| {
                scope.spawn(move || {
                    let preset = scene(&format!("return vec4f({i}.0 + 0.0 * p.x);"));
                    draw(&preset, &Bake::constants(), &Shot::new(33, 17)).pixels[0][3]
                })
            })
            .collect();
        let values: Vec<_> = threads.into_iter().map(|thread| thread.join().expect("no panic")).collect();
        assert_eq!(values, [0.0, 1.0, 2.0, 3.0]);
    });
}

// ---- everything around ----

/// A scene whose colour is the direction of view, halved and moved to 0 .. 1.
fn compass(projection: Projection) -> Preset {
    let text = "#include <camera/camera.wgsl>
        #include <color/srgb.wgsl>
        fn main_image(p: vec2f) -> vec4f {
            return vec4f(srgb_encode(0.5 + 0.5 * camera_ray(p, 0.0).direction), 1.0);
        }";
    let mut preset = Preset::of_text("compass.wgsl", text);
    preset.set(&format!("camera.projection={}", projection.name())).expect("the camera has it");
    preset
}

fn directions(picture: &Picture) -> Vec<[f32; 3]> {
    picture.pixels.iter().map(|[r, g, b, _]| [r, g, b].map(|c| 2.0 * c - 1.0)).collect()
}

fn apart(a: [f32; 3], b: [f32; 3]) -> f32 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f32>().sqrt()
}

fn unit(v: [f32; 3]) -> [f32; 3] {
    let length = v.iter().map(|part| part * part).sum::<f32>().sqrt();
    v.map(|part| part / length)
}

fn cube(preset: &Preset, side: u32, samples: u32) -> [Picture; 6] {
    let shot = Shot { samples, ..Shot::new(1, 1) };
    let shot = Projection::Cube.shot(shot, side, side).expect("it is square");
    faces(&draw(preset, &Bake::constants(), &shot))
}

#[test]
fn the_pixels_of_a_cube_look_in_the_directions_of_its_layers() {
    let mut preset = compass(Projection::Cube);
    for turned in ["camera.azimuth=77", "camera.elevation=-30"] {
        preset.set(turned).expect("the camera has it"); // and a skybox does not mind
    }
    let pictures = cube(&preset, 3, 1);
    let third = 2.0 / 3.0;
    // East, west, up, down, north, south: the middle of each, and what is right of it and above it.
    for (face, middle, right, above) in [
        (0, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        (1, [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
        (2, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        (3, [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        (4, [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        (5, [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
    ] {
        let found = directions(&pictures[face]);
        for (index, found) in found.into_iter().enumerate() {
            let (x, y) = (index as f32 % 3.0 - 1.0, 1.0 - (index / 3) as f32);
            let expected: [f32; 3] =
                std::array::from_fn(|i| middle[i] + third * (x * right[i] + y * above[i]));
            let error = apart(found, unit(expected));
            assert!(error < 2e-5, "face {face}, pixel {index}: {found:?} for {expected:?}");
        }
    }
}

#[test]
fn a_cube_is_the_same_in_a_row_as_in_a_column() {
    const SIDE: u32 = 17;
    let preset = compass(Projection::Cube);
    let column = cube(&preset, SIDE, 3);
    let row = draw(&preset, &Bake::constants(), &Shot { samples: 3, ..Shot::new(6 * SIDE, SIDE) });
    for (face, picture) in column.iter().enumerate() {
        for (y, pixels) in picture.pixels.chunks(SIDE as usize).enumerate() {
            let start = y * 6 * SIDE as usize + face * SIDE as usize;
            for (x, (a, b)) in pixels.iter().zip(&row.pixels[start..]).enumerate() {
                assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-4), "face {face}, {x}, {y}: {a:?} and {b:?}");
            }
        }
    }
}

#[test]
fn the_sky_goes_on_from_face_to_face_and_around_a_panorama() {
    const SIDE: u32 = 48;
    let sky = |projection: Projection| {
        let mut preset = Preset::of_module("scene/sky.wgsl");
        preset.set(&format!("camera.projection={}", projection.name())).expect("the camera has it");
        preset.set("sun.azimuth=180").expect("the sun has it"); // its glow is steep, and 45° from all edges
        preset
    };
    let most = |a: [f32; 4], b: [f32; 4]| (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f32::max);
    let pictures = cube(&sky(Projection::Cube), SIDE, 1);
    let ways = cube(&compass(Projection::Cube), SIDE, 1).map(|picture| directions(&picture));
    let is_edge = |index: usize| {
        let (x, y) = (index as u32 % SIDE, index as u32 / SIDE);
        x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1
    };
    let edge = |face: usize| (0..(SIDE * SIDE) as usize).filter(|i| is_edge(*i)).map(move |i| (face, i));
    let edges: Vec<(usize, usize)> = (0..6).flat_map(edge).collect();
    let mut colours = std::collections::BTreeSet::new();
    for (face, here) in &edges {
        let others = edges.iter().filter(|(other, _)| other != face);
        let way = |(face, at): &(usize, usize)| ways[*face][*at];
        let nearest = others
            .min_by(|a, b| apart(way(a), ways[*face][*here]).total_cmp(&apart(way(b), ways[*face][*here])));
        let (other, there) = *nearest.expect("there are others");
        let angle = apart(ways[*face][*here], ways[other][there]);
        assert!(angle < 2.0 / SIDE as f32, "face {face}, {here}: the next face begins {angle} rad away");
        let (a, b) = (pictures[*face].pixels[*here], pictures[other].pixels[there]);
        assert!(most(a, b) < 0.02, "face {face}, {here} is {a:?}, and beside it {b:?}");
        colours.insert((a[2] * 50.0) as i32);
    }
    assert!(colours.len() > 5, "a sky of one colour would meet itself anyhow");

    let (width, height) = (96, 48);
    let panorama = draw(&sky(Projection::Equirectangular), &Bake::constants(), &Shot::new(width, height));
    let rows: Vec<&[[f32; 4]]> = panorama.pixels.chunks(width as usize).collect();
    for (y, row) in rows.iter().enumerate() {
        let (left, right) = (row[0], row[width as usize - 1]);
        assert!(most(left, right) < 0.02, "row {y}: {left:?} at the left, {right:?} at the right");
    }
    for pole in [rows[0], rows[height as usize - 1]] {
        let off = pole.iter().map(|pixel| most(*pixel, pole[0])).fold(0.0, f32::max);
        assert!(off < 0.02, "a pole is one colour, and not {off} off it");
    }
}

#[test]
fn a_panorama_has_the_camera_s_azimuth_in_its_middle_and_a_level_horizon() {
    let mut preset = compass(Projection::Equirectangular);
    for turned in ["camera.azimuth=90", "camera.elevation=40"] {
        preset.set(turned).expect("the camera has it");
    }
    let found = directions(&draw(&preset, &Bake::constants(), &Shot::new(8, 4)));
    for (index, found) in found.into_iter().enumerate() {
        let (x, y) = (index % 8, index / 8);
        let azimuth = (90.0 + 45.0 * (x as f32 - 3.5)).to_radians();
        let elevation = (45.0 * (1.5 - y as f32)).to_radians();
        let level = elevation.cos();
        let expected = [level * azimuth.sin(), elevation.sin(), -level * azimuth.cos()];
        assert!(apart(found, expected) < 2e-5, "pixel {x}, {y}: {found:?} for {expected:?}");
    }
}

#[test]
fn a_pixel_is_as_wide_as_the_way_to_the_next_one() {
    let text = "#include <camera/camera.wgsl>
        #include <color/srgb.wgsl>
        fn main_image(p: vec2f) -> vec4f {
            let beside = camera_ray(p + vec2f(1.0, 0.0), 0.0).direction;
            let way = distance(camera_ray(p, 0.0).direction, beside);
            return vec4f(srgb_encode(vec3f(way / camera_pixel_angle())), 1.0);
        }";
    for (projection, width, height, middle) in [
        (Projection::Perspective, 64, 36, (31, 17)),
        (Projection::Equirectangular, 64, 32, (31, 15)),
        (Projection::Cube, 32, 192, (15, 15)),
        (Projection::Cube, 192, 32, (47, 15)),
    ] {
        let mut preset = Preset::of_text("ratio.wgsl", text);
        preset.set(&format!("camera.projection={}", projection.name())).expect("the camera has it");
        let picture = draw(&preset, &Bake::constants(), &Shot::new(width, height));
        let ratio = picture.pixels[(middle.1 * width + middle.0) as usize][0];
        assert!((ratio - 1.0).abs() < 0.01, "{projection:?}, {width}×{height}: {ratio}");
    }
}

#[test]
fn a_scene_without_the_camera_has_no_projection_to_choose() {
    let mut preset = scene("return vec4f(p, 0.0, 1.0);");
    let survey = Compose::default().survey(&Library::standard(), &preset).expect("it is right");
    let error = Projection::Cube.set(&mut preset, &survey.declarations).expect_err("it has no camera");
    expect_text("no-projection.txt", &error.render(false));
    assert_eq!(Projection::of(&shader(&preset, &Bake::constants())), Projection::Perspective);
    let error = Projection::Cube.shot(Shot::new(1, 1), 512, 256).expect_err("it is not square");
    expect_text("face-not-square.txt", &error.render(false));
}

// ---- files ----

#[test]
fn dithering_keeps_the_mean() {
    let (width, height) = (512, 128);
    let ramp = |x: u32, from: f32, to: f32| from + (to - from) * (x as f32 + 0.5) / width as f32;
    for (from, to) in [(0.0, 1.0), (0.3, 0.31), (0.0, 0.01), (0.99, 1.0)] {
        let pixels: Vec<_> = (0..width * height)
            .map(|i| {
                let linear = orogen::render::srgb_decode(ramp(i % width, from, to));
                [linear, linear, linear, 1.0]
            })
            .collect();
        let picture = Picture { width, height, pixels };
        let bytes = to_srgb8(&picture);
        for channel in 0..3 {
            let mean = bytes.iter().skip(channel).step_by(4).map(|b| f64::from(*b)).sum::<f64>();
            let mean = mean / f64::from(width * height);
            let expected = f64::from(from + to) / 2.0 * 255.0;
            assert!(
                (mean - expected).abs() < 0.1,
                "{from} .. {to}, channel {channel}: {mean} for {expected}"
            );
        }
    }
}

#[test]
fn black_white_and_what_is_beyond_them_stay_exact() {
    let values = [0.0, 1.0, -0.5, 7.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
    for value in values {
        let picture = Picture { width: 64, height: 64, pixels: vec![[value, value, value, 1.0]; 64 * 64] };
        let expected = if value >= 1.0 { 255 } else { 0 };
        let bytes = to_srgb8(&picture);
        assert!(bytes.chunks(4).all(|p| p[..3] == [expected; 3] && p[3] == 255), "{value}");
    }
}

/// Red, green, blue and alpha of a PNG.
fn image(file: &[u8]) -> Vec<u8> {
    image::load_from_memory(file).expect("it is a PNG").to_rgba8().into_raw()
}

#[test]
fn files_read_back_as_what_was_drawn() {
    let pixels: Vec<_> = (0..12_u8).map(|i| [f32::from(i) / 4.0, 0.5, -1.0, f32::from(i % 2)]).collect();
    let picture = Picture { width: 4, height: 3, pixels };
    let exr = encode(&picture, Format::Exr).expect("it can be encoded");
    let read = image::load_from_memory(&exr).expect("it is an EXR").to_rgba32f();
    assert_eq!(read.as_raw().as_slice(), picture.pixels.as_flattened());
    let png = encode(&picture, Format::Png).expect("it can be encoded");
    assert_eq!(image(&png), to_srgb8(&picture));
    let jpeg = encode(&picture, Format::Jpeg).expect("it can be encoded");
    assert_eq!(jpeg, encode(&picture, Format::Jpeg).expect("it can be encoded"), "the same bytes every time");
    let read = image::load_from_memory(&jpeg).expect("it is a JPEG");
    assert_eq!((read.width(), read.height(), read.color().has_alpha()), (4, 3, false));
    assert_eq!(png, encode(&picture, Format::Png).expect("it can be encoded"), "the same bytes every time");
}

#[test]
fn the_name_of_a_file_says_its_format() {
    assert_eq!(Format::of("a/b.PNG").ok(), Some(Format::Png));
    assert_eq!(Format::of("b.exr").ok(), Some(Format::Exr));
    assert_eq!(["c.jpg", "c.JPEG"].map(|name| Format::of(name).ok()), [Some(Format::Jpeg); 2]);
    expect_text("format.txt", &Format::of("out/picture.bmp").expect_err("BMP is not written").render(false));
}

#[test]
fn a_jpeg_looks_like_the_picture() {
    // A ramp of colours: where JPEG is at its best, and a swapped channel would show.
    let at = |i: usize| (i % 64) as f32 / 63.0;
    let pixels = (0..64 * 64).map(|i| [at(i), at(i / 64), 0.2, 1.0]).collect();
    let picture = Picture { width: 64, height: 64, pixels };
    let jpeg = encode(&picture, Format::Jpeg).expect("it can be encoded");
    let (read, exact) = (image(&jpeg), to_srgb8(&picture));
    let error =
        read.iter().zip(&exact).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / exact.len() as f64;
    assert!(error < 3.0, "off by {error} of 255 on average");
}

// ---- no bands in a sky ----

/// A clear sky above the horizon through a long lens: six steps of 8 bits from the top of the picture to its bottom.
fn clear_sky(dither: bool) -> Preset {
    let text = "
        #include <camera/camera.wgsl>
        #include <camera/display.wgsl>
        #include <sky/sky.wgsl>
        fn main_image(frag_coord: vec2f) -> vec4f {
            let ray = camera_ray(frag_coord, 0.0);
            return vec4f(display_color(sky_radiance(ray.origin, ray.direction), frag_coord), 1.0);
        }";
    let mut preset = Preset::of_text("sky.wgsl", text);
    let dither = format!("display.dither={dither}");
    let all = ["sky.glow=[0,0,0]", "camera.elevation=12", "camera.focal_length=300", dither.as_str()];
    for assignment in all {
        preset.set(assignment).expect("it is declared");
    }
    preset
}

/// The mean of each row's green, in steps of 8 bits, after `round` has made a number of steps of it.
fn rows(picture: &Picture, round: impl Fn(f64) -> f64) -> Vec<f64> {
    let steps = |pixel: &[f32; 4]| round(f64::from(srgb_encode(pixel[1])) * 255.0);
    let mean = |row: &[[f32; 4]]| row.iter().map(steps).sum::<f64>() / row.len() as f64;
    picture.pixels.chunks_exact(picture.width as usize).map(mean).collect()
}

fn furthest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn steps_between(rows: &[f64]) -> Vec<f64> {
    rows.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

fn mean(rows: &[f64]) -> f64 {
    rows.iter().sum::<f64>() / rows.len() as f64
}

#[test]
fn a_clear_sky_has_no_bands_on_an_8_bit_display() {
    let shot = Shot::new(SIZE.0, SIZE.1);
    let [plain, dithered] = [false, true].map(|on| draw(&clear_sky(on), &Bake::constants(), &shot));
    let exact = rows(&plain, |steps| steps);
    let span = exact[0] - exact[exact.len() - 1];
    assert!(span.abs() > 4.0, "the sky spans {span} steps: too few for bands");
    // As an 8-bit target rounds. Without dither there are bands: rows alike, then a jump.
    let banded = rows(&plain, f64::round);
    let jump = steps_between(&banded).into_iter().map(f64::abs).fold(0.0, f64::max);
    assert!(furthest(&banded, &exact) > 0.4 && jump > 0.3, "{} {jump}", furthest(&banded, &exact));
    let smooth = rows(&dithered, f64::round);
    let off = furthest(&smooth, &exact);
    assert!(off < 0.1, "a row is off by {off} steps");
    let uneven = furthest(&steps_between(&smooth), &steps_between(&exact));
    assert!(uneven < 0.12, "from one row to the next it steps by {uneven} too much");
    assert!((mean(&smooth) - mean(&exact)).abs() < 0.01, "{} for {}", mean(&smooth), mean(&exact));
}

#[test]
fn a_clear_sky_has_no_bands_in_a_file_whatever_the_samples() {
    for samples in [1, 3] {
        let shot = Shot { samples, ..Shot::new(SIZE.0, SIZE.1) };
        let exact = rows(&draw(&clear_sky(false), &Bake::constants(), &shot), |steps| steps);
        for dither in [false, true] {
            // Files are dithered after the samples are averaged; a scene that dithers as well does no harm.
            let picture = draw(&clear_sky(dither), &Bake::constants(), &shot);
            let bytes = to_srgb8(&picture);
            let row = |row: &[u8]| row.chunks_exact(4).map(|p| f64::from(p[1])).sum::<f64>();
            let width = SIZE.0 as usize;
            let found: Vec<f64> = bytes.chunks_exact(4 * width).map(|r| row(r) / width as f64).collect();
            let off = furthest(&found, &exact);
            assert!(off < 0.15, "{samples} samples, {dither}: a row is off by {off} steps");
            let off = (mean(&found) - mean(&exact)).abs();
            assert!(off < 0.02, "{samples} samples, {dither}: the mean is off by {off} steps");
        }
    }
}

// ---- what cannot be drawn ----

#[test]
fn an_unknown_adapter_lists_those_there_are() {
    let error = Gpu::new(Some("Voodoo 2")).err().expect("there is none");
    assert!(!is_no_adapter(&error));
    let text = error.to_string();
    assert!(text.contains("error[OR0902]: there is no GPU adapter whose name contains `Voodoo 2`"), "{text}");
    assert!(text.contains(&format!("there is `{}`", GPU.name())), "{text}");
    let part: String = GPU.name().chars().take(5).collect();
    let found = Gpu::new(Some(&part.to_uppercase())).expect("a part of the name in any case will do");
    assert!(found.name().starts_with(&part));
}

#[test]
fn no_adapter_is_recognised_and_told_how_to_install_one() {
    let error = Error::from(orogen::render::RenderError::NoAdapter);
    assert!(is_no_adapter(&error));
    if cfg!(target_os = "linux") {
        expect_text("no-adapter.txt", &error.render(false));
    }
}

#[test]
fn sizes_of_nothing_and_beyond_the_device_are_refused() {
    let preset = scene("return vec4f(p, 0.0, 1.0);");
    expect_text("size-zero.txt", &refusal(&preset, &Shot::new(0, 144)).render(false));
    let huge = refusal(&preset, &Shot::new(256, GPU.max_size() + 1)).to_string();
    assert!(huge.contains("error[OR0908]"), "{huge}");
    assert!(huge.contains(&format!("at most {}×{}", GPU.max_size(), GPU.max_size())), "{huge}");
    let huge = refusal(&preset, &Shot::new(u32::MAX, u32::MAX)).to_string();
    assert!(huge.contains("a picture of 4294967295×4294967295 pixels"), "{huge}");
}

#[test]
fn shots_of_no_samples_at_no_time_or_with_the_mouse_nowhere_are_refused() {
    let preset = scene("return vec4f(p, 0.0, 1.0);");
    let shot = Shot::new(8, 8);
    expect_text("samples-zero.txt", &refusal(&preset, &Shot { samples: 0, ..shot }).render(false));
    expect_text("time-nan.txt", &refusal(&preset, &Shot { time: f32::NAN, ..shot }).render(false));
    let mouse = Some([0.0, f32::INFINITY, 0.0, 0.0]);
    expect_text("mouse-nowhere.txt", &refusal(&preset, &Shot { mouse, ..shot }).render(false));
}

#[test]
fn a_shader_with_textures_is_refused_by_their_names() {
    let text = "
        @group(0) @binding(3) var heights: texture_2d<f32>;
        @group(0) @binding(4) var unread: sampler;
        @group(1) @binding(0) var<storage, read> rocks: array<vec4f>;
        fn touch() -> f32 { return rocks[0].x; }
        @fragment fn picture(@builtin(position) p: vec4f) -> @location(0) vec4f {
            return textureLoad(heights, vec2i(p.xy), 0) + touch();
        }";
    expect_text("bindings.txt", &refusal(&Preset::of_text("own.wgsl", text), &Shot::new(8, 8)).render(false));
}

#[test]
fn a_shader_without_a_fragment_entry_point_is_refused() {
    let shot = Shot::new(8, 8);
    let compute = Preset::of_text("own.wgsl", "@compute @workgroup_size(1) fn main() {}");
    expect_text("no-fragment.txt", &refusal(&compute, &shot).render(false));
    expect_text("no-entry.txt", &refusal(&Preset::of_module("noise/pcg.wgsl"), &shot).render(false));
}

#[test]
fn what_wgpu_refuses_is_told_in_its_words() {
    let text = "@fragment fn picture() -> @location(0) vec4u { return vec4u(1u); }";
    let error = refusal(&Preset::of_text("own.wgsl", text), &Shot::new(8, 8)).to_string();
    assert!(error.contains("error[OR0906]: wgpu refuses the work"), "{error}");
    assert!(error.contains("note: In Device::create_render_pipeline"), "{error}");
    // And the device is as good as before.
    let picture = draw(&scene("return vec4f(p.x);"), &Bake::constants(), &Shot::new(8, 8));
    assert_eq!(picture.pixels.len(), 64);
}
