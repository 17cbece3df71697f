//! Ground truth for a host: a sampler on the host's own device, and heightmaps whose tiles fit together.
//!
//! `UPDATE=1 cargo test --test sample` writes the expected error texts anew.

#![cfg(feature = "render")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;
use std::sync::LazyLock;

use orogen::render::{Gpu, HeightFormat, Heightmap, Tile, encode_heights, heightmap, heights_about};
use orogen::sample::{Column, Kind, Points, Query, Sampler, Scalar, evaluate};
use orogen::{Error, Library, Preset, Templates};

/// A host's own: nothing of Orogen opened it.
static HOST: LazyLock<(wgpu::Device, wgpu::Queue)> = LazyLock::new(|| {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
        .expect("the tests run on lavapipe: `cargo xtask test`");
    pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default())).expect("a device opens")
});

fn gpu() -> Gpu {
    Gpu::of(&HOST.0, &HOST.1)
}

fn alpine() -> Preset {
    Preset::named("alpine").unwrap()
}

fn sampler(expression: &str, columns: &[&str]) -> Result<Sampler, Error> {
    Sampler::new(&gpu(), &Library::standard(), &alpine(), expression, columns)
}

/// Holds the text of `error` against the file of that name.
fn expect(name: &str, error: &Error) {
    let (path, text) = (Path::new("tests/render").join(name).with_extension("txt"), error.render(false));
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    assert_eq!(
        text,
        std::fs::read_to_string(&path).unwrap_or_default(),
        "{}; UPDATE=1 writes it",
        path.display()
    );
}

// ---- samplers ----

#[test]
fn a_sampler_gives_batch_after_batch_what_eval_gives() {
    let mut land = sampler("terrain_height_grad(p)", &["x", "y"]).unwrap();
    let columns = ["x", "y"].map(|name| Column { name: name.into(), kind: Kind::F32 }).to_vec();
    for batch in [1_usize, 300, 7, 1000] {
        let points: Vec<[f32; 2]> =
            (0..batch).map(|i| [31.7 * i as f32 - 9000.0, 5000.0 - 12.3 * i as f32]).collect();
        let found: Vec<[f32; 3]> = land.run(&points).unwrap();
        let values = points.iter().flatten().map(|number| Scalar::F32(*number)).collect();
        let points = Points { columns: columns.clone(), values };
        let preset = alpine();
        let query = Query {
            expression: "terrain_height_grad(p)",
            includes: &[],
            preset: Some(&preset),
            points: &points,
        };
        let table = evaluate(&gpu(), &Library::standard(), &Templates::standard(), &query).unwrap();
        let flat: Vec<Scalar> = found.iter().flatten().map(|number| Scalar::F32(*number)).collect();
        assert_eq!(flat, table.values);
        assert_eq!(land.table(&points).unwrap(), table);
    }
    assert!(land.run::<2, 3>(&[]).unwrap().is_empty());
}

#[test]
fn an_expression_without_columns_has_one_value() {
    let mut sun = sampler("key_direction()", &[]).unwrap();
    let found: Vec<[f32; 3]> = sun.run(&[[], []]).unwrap();
    assert_eq!(found.len(), 2);
    assert_eq!(found[0], found[1]);
    let length = found[0].iter().map(|x| x * x).sum::<f32>().sqrt();
    assert!((length - 1.0).abs() < 1e-5, "{found:?}");
}

#[test]
fn a_scene_s_own_entry_points_and_bindings_are_no_business_of_a_sampler() {
    let scene = "#include <terrain/height.wgsl>
#include <frame.wgsl>
@group(0) @binding(0) var<uniform> view: vec4f;
@fragment fn draw(@builtin(position) p: vec4f) -> @location(0) vec4f { return view * terrain_height(p.xy) * frame.time; }
";
    let preset = Preset::of_text("host.wgsl", scene);
    let mut height =
        Sampler::new(&gpu(), &Library::standard(), &preset, "terrain_height(p)", &["x", "y"]).unwrap();
    assert!(height.run::<2, 1>(&[[100.0, 200.0]]).unwrap()[0][0].is_finite());
    let bound = Sampler::new(&gpu(), &Library::standard(), &preset, "view.x", &[]);
    assert!(bound.err().unwrap().to_string().contains("error[OR0911]"));
}

#[test]
fn a_host_is_told_what_does_not_fit() {
    let mut height = sampler("terrain_height_grad(p)", &["x", "y"]).unwrap();
    expect("a-row-of-another-length", &height.run::<3, 3>(&[[0.0; 3]]).unwrap_err());
    expect("a-value-of-another-length", &height.run::<2, 1>(&[[0.0; 2]]).unwrap_err());
    let whole = height.table(&Points { columns: vec![Column::parse("n:u32").unwrap()], values: Vec::new() });
    expect("points-of-other-columns", &whole.unwrap_err());
    let misspelt = sampler("terain_height(p)", &["x", "y"]).err().unwrap();
    assert!(misspelt.to_string().contains("terrain_height"), "{misspelt}");
}

#[test]
fn the_host_s_own_error_handler_hears_nothing() {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};
    let heard = Arc::new(AtomicUsize::new(0));
    let count = heard.clone();
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).unwrap();
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default())).unwrap();
    device.on_uncaptured_error(Arc::new(move |_| {
        count.fetch_add(1, Ordering::Relaxed);
    }));
    let gpu = Gpu::of(&device, &queue);
    let mut good =
        Sampler::new(&gpu, &Library::standard(), &alpine(), "terrain_height(p)", &["x", "y"]).unwrap();
    good.run::<2, 1>(&[[1.0, 2.0]]).unwrap();
    device.destroy();
    let error = good.run::<2, 1>(&[[1.0, 2.0]]).unwrap_err();
    assert!(!error.to_string().is_empty());
    assert_eq!(heard.load(Ordering::Relaxed), 0);
}

// ---- heightmaps ----

fn map(preset: &Preset, tile: Tile) -> Result<Heightmap, Error> {
    heightmap(&gpu(), &Library::standard(), preset, tile, 0.0, &mut |_, _| {})
}

/// The numbers of a column of a file, as bytes.
fn column(file: &[u8], format: HeightFormat, pixels: usize, index: usize) -> Vec<[u8; 4]> {
    let wide: Vec<[u8; 4]> = match format {
        HeightFormat::R16 => file.chunks_exact(2).map(|b| [b[0], b[1], 0, 0]).collect(),
        HeightFormat::Png => {
            let picture = image::load_from_memory(file).unwrap();
            assert_eq!(picture.color(), image::ColorType::L16);
            picture.to_luma16().iter().map(|level| u32::from(*level).to_le_bytes()).collect()
        }
        HeightFormat::Exr => {
            use exr::prelude::{ReadChannels, ReadLayers, read};
            let image = read()
                .no_deep_data()
                .largest_resolution_level()
                .all_channels()
                .first_valid_layer()
                .all_attributes()
                .non_parallel()
                .from_buffered(std::io::Cursor::new(file))
                .unwrap();
            let channels = image.layer_data.channel_data.list;
            assert_eq!((channels.len(), channels[0].name.to_string()), (1, "Y".to_owned()));
            channels[0].sample_data.values_as_f32().map(f32::to_le_bytes).collect()
        }
    };
    assert_eq!(wide.len(), pixels * pixels);
    wide.into_iter().skip(index).step_by(pixels).collect()
}

#[test]
fn neighbours_agree_on_their_border_in_every_format() {
    // Near the origin, and 2,000 km out; a width that has no end in binary; different numbers of samples.
    for (preset, origin, size) in [
        ("alpine", [-9_570_000, -6_988_100], 333_100),
        ("dunes", [2_000_000_000, -1_999_999_700], 3_000_000),
        ("canyon", [100, -100], 777_777),
    ] {
        let preset = Preset::named(preset).unwrap();
        let pixels = 33;
        let west = Tile { origin, size, pixels };
        let east = Tile { origin: [origin[0] + size as i64, origin[1]], size, pixels };
        let [west, east] = [west, east].map(|tile| map(&preset, tile).unwrap());
        let range = west.range(&preset).unwrap();
        assert_eq!(range, east.range(&preset).unwrap(), "what 16 bits mean is the preset's");
        assert_eq!((west.outside(range), east.outside(range)), (0, 0));
        for format in [HeightFormat::Png, HeightFormat::Exr, HeightFormat::R16] {
            let [a, b] = [&west, &east].map(|map| encode_heights(map, format, range).unwrap());
            let (last, first) = (column(&a, format, 33, 32), column(&b, format, 33, 0));
            assert_eq!(last, first, "{} {format:?}", preset.name());
            assert_ne!(
                last,
                column(&a, format, 33, 31),
                "{} {format:?}: the land is not the same all over",
                preset.name()
            );
        }
    }
}

#[test]
fn a_heightmap_is_the_land_at_its_samples() {
    let tile = Tile { origin: [-1_000_000, 500_000], size: 2_000_000, pixels: 9 };
    let map = map(&alpine(), tile).unwrap();
    let mut height = sampler("terrain_height(p)", &["x", "y"]).unwrap();
    let places: Vec<[f32; 2]> =
        (0..81).map(|i| [250.0 * (i % 9) as f32 - 1000.0, 250.0 * (i / 9) as f32 + 500.0]).collect();
    let expected: Vec<[f32; 1]> = height.run(&places).unwrap();
    assert_eq!(map.heights, expected.concat());
    // 16 bits hold each to half a step.
    let range = map.range(&alpine()).unwrap();
    let step = (range[1] - range[0]) / 65_535.0;
    let file = encode_heights(&map, HeightFormat::R16, range).unwrap();
    for (bytes, height) in file.chunks_exact(2).zip(&map.heights) {
        let read = range[0] + step * f32::from(u16::from_le_bytes([bytes[0], bytes[1]]));
        assert!((read - height).abs() <= 0.501 * step, "{read} m for {height} m");
    }
}

#[test]
fn heights_outside_of_the_range_come_out_as_its_ends() {
    let tile = Tile { origin: [0, 0], size: 1000, pixels: 2 };
    let map = Heightmap { tile, heights: vec![-5.0, 0.0, 10.0, 99.0], bounds: None };
    assert_eq!((map.outside([0.0, 10.0]), map.span()), (2, [-5.0, 99.0]));
    let file = encode_heights(&map, HeightFormat::R16, [0.0, 10.0]).unwrap();
    assert_eq!(file, [0, 0, 0, 0, 255, 255, 255, 255]);
}

#[test]
fn the_words_beside_a_file_say_what_its_numbers_mean() {
    let tile = Tile { origin: [-1500, 250], size: 4000, pixels: 3 };
    let map = Heightmap { tile, heights: vec![1.0; 9], bounds: Some([0.0, 2.0]) };
    let about: serde_json::Value =
        serde_json::from_str(&heights_about(&map, "alpine", HeightFormat::R16, [-10.0, 10.0])).unwrap();
    assert_eq!(about["origin"], serde_json::json!({ "x": -1.5, "z": 0.25 }));
    assert_eq!((&about["size"], &about["spacing"]), (&4.0.into(), &2.0.into()));
    assert_eq!(about["encoding"]["height_of_65535"], 10.0);
    assert_eq!(about["encoding"]["endian"], "little");
}

#[test]
fn progress_counts_every_height() {
    let tile = Tile { origin: [0, 0], size: 600_000, pixels: 300 };
    let mut seen = Vec::new();
    heightmap(&gpu(), &Library::standard(), &alpine(), tile, 2.0, &mut |done, of| seen.push((done, of)))
        .unwrap();
    assert_eq!(seen.last(), Some(&(90_000, 90_000)));
    assert!(seen.len() > 1 && seen.is_sorted());
}

#[test]
fn what_cannot_be_measured_says_why() {
    let tile = Tile { origin: [0, 0], size: 100_000, pixels: 5 };
    let refused = |preset: &str, tile| map(&Preset::named(preset).unwrap(), tile).unwrap_err();
    expect("a-scene-without-land", &refused("flight", tile));
    expect("a-tile-of-one-sample", &refused("alpine", Tile { pixels: 1, ..tile }));
    expect("a-tile-too-far-out", &refused("alpine", Tile { origin: [9_000_000_000_000; 2], ..tile }));
    expect(
        "a-tile-too-fine-for-its-place",
        &refused("alpine", Tile { origin: [900_000_000_000, 0], pixels: 513, ..tile }),
    );
    expect("a-tile-without-width", &refused("alpine", Tile { size: 0, ..tile }));
    let footprint = heightmap(&gpu(), &Library::standard(), &alpine(), tile, -1.0, &mut |_, _| {});
    expect("a-pixel-of-no-width", &footprint.unwrap_err());
    let flat = Heightmap { tile: Tile { pixels: 2, ..tile }, heights: vec![0.0; 4], bounds: None };
    expect("a-range-that-is-none", &encode_heights(&flat, HeightFormat::Png, [5.0, 5.0]).unwrap_err());
    expect("a-land-without-bounds", &flat.range(&alpine()).unwrap_err());
    expect("a-format-of-no-heights", &HeightFormat::of("land.jpg").unwrap_err());
}

#[test]
fn a_planet_s_land_can_be_measured_given_a_range() {
    let mut preset = Preset::of_module("scene/landscape.wgsl");
    preset.set("terrain.relief=planet").unwrap();
    let tile = Tile { origin: [0, 0], size: 100_000, pixels: 3 };
    let map = map(&preset, tile).unwrap();
    assert_eq!(map.bounds, None);
    assert!(encode_heights(&map, HeightFormat::R16, [-9000.0, 9000.0]).is_ok());
}
