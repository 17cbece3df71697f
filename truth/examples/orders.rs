//! Traces what `tests/accuracy/sky_orders.rs` holds the sky against, and what `wgsl/sky/orders.wgsl` was fitted to:
//!
//! ```text
//! cargo run --release -p truth --example orders -- views 100000 > tests/accuracy/orders/views.csv
//! cargo run --release -p truth --example orders -- others 15000 > tests/accuracy/orders/others.csv
//! cargo run --release -p truth --example orders -- irradiance 400000 > tests/accuracy/orders/irradiance.csv
//! cargo run --release -p truth --example orders -- field 100000
//! ```
#![allow(clippy::print_stdout, reason = "it prints a table")]

use truth::orders::{Air, Paths};

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let mode = args.get(1).map_or("", String::as_str);
    let count: usize = args.get(2).and_then(|x| x.parse().ok()).unwrap_or(100_000);
    match mode {
        "views" => views(count),
        "others" => others(count),
        "irradiance" => irradiance(count),
        "field" => field(count),
        _ => println!("views | others | irradiance | field [paths]"),
    }
}

fn colours(air: impl Fn(usize) -> Air) -> Vec<Paths> {
    (0..3).map(|channel| Paths::new(air(channel))).collect()
}

/// Three values and their standard errors.
fn line(values: [(f64, f64); 3]) -> String {
    let text = |x: f64| format!("{x:.4e}");
    let [a, b, c] = values;
    [text(a.0), text(b.0), text(c.0), format!("{:.1e},{:.1e},{:.1e}", a.1, b.1, c.1)].join(",")
}

fn seen(colours: &[Paths], view: [f64; 4], count: usize, seed: u64) -> String {
    let [height, sun, zenith, azimuth] = view;
    line(std::array::from_fn(|channel| {
        let seed = 3 * seed + channel as u64;
        let estimate =
            colours[channel].radiance(height, toward(zenith, azimuth), toward(sun, 0.0), count, seed);
        (estimate.all, estimate.error)
    }))
}

/// Views of every sort, from heights where eyes are, under suns from high to well under the horizon.
fn views(count: usize) {
    let colours = colours(Air::earth);
    let suns = [20.0, 45.0, 65.0, 75.0, 82.0, 85.0, 88.0, 89.0, 90.0, 92.0, 94.0, 96.0];
    let heights = [0.5, 500.0, 2000.0, 5000.0, 10_000.0];
    let azimuths = [0.0, 180.0, 30.0, 110.0, 60.0, 150.0, 10.0, 90.0];
    let zeniths =
        [[0.0, 20.0, 35.0, 50.0, 58.0], [65.0, 70.0, 75.0, 80.0, 84.0], [86.0, 87.0, 88.0, 89.0, 89.8]];
    println!("height,sun zenith,view zenith,azimuth,red,green,blue,error,error,error");
    let mut row = 0;
    for (i, &sun) in suns.iter().enumerate() {
        for (j, &height) in heights.iter().enumerate() {
            for (k, band) in zeniths.iter().enumerate() {
                let zenith = band[(i + 2 * j + k) % band.len()];
                let far = |azimuth: &&f64| {
                    let cosine: f64 =
                        (0..3).map(|x| toward(sun, 0.0)[x] * toward(zenith, **azimuth)[x]).sum();
                    cosine < 10.0_f64.to_radians().cos()
                };
                let Some(&azimuth) = azimuths.iter().cycle().skip(row % 8).take(8).find(far) else {
                    continue;
                };
                row += 1;
                let count = if sun > 91.0 { 5 * count } else { count };
                let text = seen(&colours, [height, sun, zenith, azimuth], count, row as u64);
                println!("{height},{sun},{zenith},{azimuth},{text}");
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
    println!("air,height,sun zenith,view zenith,azimuth,red,green,blue,error,error,error");
    let airs = [("haze4", colours(hazy(4.0))), ("haze10", colours(hazy(10.0))), ("mars", colours(Air::mars))];
    for (name, colours) in airs {
        let mut row = 0;
        for sun in [20.0, 65.0, 85.0, 90.0, 94.0] {
            for height in [0.5, 5000.0] {
                for (zenith, azimuth) in
                    [(0.0, 0.0), (60.0, 180.0), (75.0, 40.0), (88.0, 110.0), (88.0, 180.0)]
                {
                    row += 1;
                    let text = seen(&colours, [height, sun, zenith, azimuth], count, row);
                    println!("{name},{height},{sun},{zenith},{azimuth},{text}");
                }
            }
        }
    }
}

/// Level ground, and level planes above it, under the whole sky.
fn irradiance(count: usize) {
    let colours = colours(Air::earth);
    println!("height,sun zenith,red,green,blue,error,error,error");
    for height in [0.0, 3000.0, 10_000.0] {
        for sun in [0.0, 30.0, 50.0, 65.0, 75.0, 80.0, 85.0, 88.0, 90.0, 92.0, 94.0, 96.0_f64] {
            let count = if sun > 91.0 { 4 * count } else { count };
            let values = std::array::from_fn(|channel| {
                colours[channel].irradiance(height, sun.to_radians().cos(), count, (sun + height) as u64 + 1)
            });
            println!("{height},{sun},{}", line(values));
        }
    }
}

/// The light of all directions at points: what `wgsl/sky/orders.wgsl` was fitted to.
fn field(count: usize) {
    let colours = colours(Air::earth);
    let heights = [0.0, 500.0, 1e3, 2e3, 4e3, 7e3, 11e3, 16e3, 23e3, 32e3, 45e3, 60e3];
    let suns = [
        0.0, 20.0, 40.0, 55.0, 65.0, 72.0, 77.0, 81.0, 84.0, 86.0, 88.0, 89.0, 90.0, 91.0, 92.0, 93.0, 94.0,
        95.0, 96.0, 97.0, 98.0, 100.0, 102.0, 105.0_f64,
    ];
    for (i, &height) in heights.iter().enumerate() {
        for (j, &sun) in suns.iter().enumerate() {
            for (channel, paths) in colours.iter().enumerate() {
                let seed = (i * 1000 + j * 10 + channel) as u64;
                let count = if sun > 92.0 { 2 * count } else { count };
                let field = paths.field(height, sun.to_radians().cos(), [24, 12], count, seed);
                let text: Vec<String> = field.iter().map(|x| format!("{x:.4e}")).collect();
                println!("{height},{sun},{channel},{}", text.join(","));
            }
        }
    }
}

fn toward(zenith: f64, azimuth: f64) -> [f64; 3] {
    let (sine, cosine) = zenith.to_radians().sin_cos();
    let (across, ahead) = azimuth.to_radians().sin_cos();
    [sine * ahead, cosine, sine * across]
}
