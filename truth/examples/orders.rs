//! Prints what `tests/accuracy/sky_orders.rs` holds the sky against.
#![allow(clippy::print_stdout, reason = "it prints a table")]

use truth::orders::{Air, Paths};

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let mode = args.get(1).map_or("check", String::as_str);
    let count: usize = args.get(2).and_then(|x| x.parse().ok()).unwrap_or(100_000);
    let colours: Vec<Paths> = (0..3).map(|channel| Paths::new(Air::earth(channel))).collect();
    if mode == "check" {
        for (height, mu) in [(0.0, 1.0), (0.0, 0.5), (0.0, 0.1)] {
            for paths in &colours {
                println!("T {height} {mu} {:.6}", paths.sunlight(6_360e3 + height, mu));
            }
        }
        for (sun, view, azimuth) in [(45.0, 0.0, 0.0), (65.0, 80.0, 90.0), (85.0, 80.0, 90.0), (94.0, 60.0, 0.0)] {
            let start = std::time::Instant::now();
            for paths in &colours {
                let estimate = paths.radiance(500.0, toward(view, azimuth), toward(sun, 0.0), count, 7);
                println!("{sun} {view} {azimuth}: {estimate:?}");
            }
            println!("{:?}", start.elapsed());
        }
    }
    if mode == "rows" {
        rows(&colours, count);
    }
    if mode == "other" {
        others(count);
    }
    if mode == "irradiance" {
        irradiances(&colours, count);
    }
    if mode == "field" {
        let heights = [0.0, 500.0, 1e3, 2e3, 4e3, 7e3, 11e3, 16e3, 23e3, 32e3, 45e3, 60e3];
        let suns = [
            0.0, 20.0, 40.0, 55.0, 65.0, 72.0, 77.0, 81.0, 84.0, 86.0, 88.0, 89.0, 90.0, 91.0, 92.0, 93.0, 94.0, 95.0,
            96.0, 97.0, 98.0, 100.0, 102.0, 105.0_f64,
        ];
        for (i, &height) in heights.iter().enumerate() {
            for (j, &sun) in suns.iter().enumerate() {
                for (channel, paths) in colours.iter().enumerate() {
                    let seed = (i * 1000 + j * 10 + channel) as u64;
                    let count = if sun > 92.0 { 2 * count } else { count };
                    let field = paths.field(height, sun.to_radians().cos(), [24, 12], count, seed);
                    let text: Vec<String> = field.iter().map(|x| format!("{x:.4e}")).collect();
                    println!("{height} {sun} {channel} {}", text.join(" "));
                }
            }
        }
    }
}

/// Hazier air, and Mars.
fn others(count: usize) {
    let hazy = |times: f64| {
        move |channel: usize| {
            let mut air = Air::earth(channel);
            air.mie[0] *= times;
            air.mie[1] *= times;
            air
        }
    };
    println!("air,height,sun_zenith,view_zenith,view_azimuth,channel,first,all,standard_error");
    let airs: [(&str, Box<dyn Fn(usize) -> Air>); 3] =
        [("haze4", Box::new(hazy(4.0))), ("haze10", Box::new(hazy(10.0))), ("mars", Box::new(Air::mars))];
    for (name, air) in airs {
        let colours: Vec<Paths> = (0..3).map(|channel| Paths::new(air(channel))).collect();
        let mut row = 0;
        for sun in [20.0, 65.0, 85.0, 90.0, 94.0] {
            for height in [0.5, 5000.0] {
                for (zenith, azimuth) in [(0.0, 0.0), (60.0, 180.0), (75.0, 40.0), (88.0, 110.0), (88.0, 180.0)] {
                    row += 1;
                    for (channel, paths) in colours.iter().enumerate() {
                        let estimate =
                            paths.radiance(height, toward(zenith, azimuth), toward(sun, 0.0), count, 3 * row + channel as u64);
                        let (first, all, error) = (estimate.first, estimate.all, estimate.error);
                        println!("{name},{height},{sun},{zenith},{azimuth},{channel},{first:.4e},{all:.4e},{error:.1e}");
                    }
                }
            }
        }
    }
}

/// Level ground, and level planes above it, under the whole sky.
fn irradiances(colours: &[Paths], count: usize) {
    println!("height,sun_zenith,channel,irradiance,standard_error");
    for height in [0.0, 3000.0, 10_000.0] {
        for sun in [0.0, 30.0, 50.0, 65.0, 75.0, 80.0, 85.0, 88.0, 90.0, 92.0, 94.0, 96.0_f64] {
            for (channel, paths) in colours.iter().enumerate() {
                let count = if sun > 91.0 { 4 * count } else { count };
                let (mean, error) = paths.irradiance(height, sun.to_radians().cos(), count, (sun + height) as u64 + 1);
                println!("{height},{sun},{channel},{mean:.4e},{error:.1e}");
            }
        }
    }
}

/// Views of every sort, from heights where eyes are, under suns from high to well under the horizon.
fn rows(colours: &[Paths], count: usize) {
    let suns = [20.0, 45.0, 65.0, 75.0, 82.0, 85.0, 88.0, 89.0, 90.0, 92.0, 94.0, 96.0];
    let heights = [0.5, 500.0, 2000.0, 5000.0, 10_000.0];
    let azimuths = [0.0, 180.0, 30.0, 110.0, 60.0, 150.0, 10.0, 90.0];
    let zeniths = [[0.0, 20.0, 35.0, 50.0, 58.0], [65.0, 70.0, 75.0, 80.0, 84.0], [86.0, 87.0, 88.0, 89.0, 89.8]];
    println!("height,sun_zenith,view_zenith,view_azimuth,channel,first,all,standard_error");
    let mut row = 0;
    for (i, &sun) in suns.iter().enumerate() {
        for (j, &height) in heights.iter().enumerate() {
            for (k, band) in zeniths.iter().enumerate() {
                let zenith = band[(i + 2 * j + k) % band.len()];
                let sun_direction = toward(sun, 0.0);
                let far = |azimuth: &&f64| {
                    let cosine: f64 = (0..3).map(|x| sun_direction[x] * toward(zenith, **azimuth)[x]).sum();
                    cosine < 10.0_f64.to_radians().cos()
                };
                let Some(&azimuth) = azimuths.iter().cycle().skip(row % 8).take(8).find(far) else { continue };
                row += 1;
                let count = if sun > 91.0 { 2 * count } else { count };
                for (channel, paths) in colours.iter().enumerate() {
                    let view = toward(zenith, azimuth);
                    let estimate = paths.radiance(height, view, sun_direction, count, (3 * row + channel) as u64);
                    let (first, all, error) = (estimate.first, estimate.all, estimate.error);
                    println!("{height},{sun},{zenith},{azimuth},{channel},{first:.4e},{all:.4e},{error:.1e}");
                }
            }
        }
    }
}

fn toward(zenith: f64, azimuth: f64) -> [f64; 3] {
    let (sine, cosine) = zenith.to_radians().sin_cos();
    let (across, ahead) = azimuth.to_radians().sin_cos();
    [sine * ahead, cosine, sine * across]
}
