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

fn toward(zenith: f64, azimuth: f64) -> [f64; 3] {
    let (sine, cosine) = zenith.to_radians().sin_cos();
    let (across, ahead) = azimuth.to_radians().sin_cos();
    [sine * ahead, cosine, sine * across]
}
