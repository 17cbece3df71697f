//! Prints `tests/accuracy/cloud_slab.csv`: radiance of cloud slabs, all orders. Some minutes.

#![allow(clippy::print_stdout, reason = "it prints a table")]

use truth::cloud_slab::{Medium, View, follow};

fn main() {
    let photons = std::env::args().nth(1).map_or(250_000, |text| text.parse().expect("how many photons"));
    println!("albedo,tau,sun_zenith,view_zenith,view_azimuth,above,radiance,first_order,standard_error");
    let common = [(0.0, 0.0), (30.0, 90.0), (45.0, 0.0), (60.0, 180.0), (60.0, 0.0), (75.0, 60.0)];
    let other = [(15.0, 180.0), (40.0, 135.0), (50.0, 90.0), (70.0, 0.0), (70.0, 180.0), (80.0, 30.0)];
    print(photons, 1, 1.0, &[0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0], &[0.0, 30.0, 60.0, 80.0], &common);
    print(photons, 33, 0.9, &[2.0, 16.0], &[0.0, 30.0, 60.0, 80.0], &common);
    print(
        photons,
        1000,
        1.0,
        &[0.5, 0.7, 2.0, 3.0, 6.0, 12.0, 24.0, 48.0],
        &[15.0, 45.0, 60.0, 70.0, 75.0],
        &other,
    );
}

/// A row for each view (zenith and azimuth, from above and from below), for each sun, for each thickness.
fn print(photons: u32, seed: u64, albedo: f64, taus: &[f64], suns: &[f64], directions: &[(f64, f64)]) {
    let views: Vec<View> = [true, false]
        .into_iter()
        .flat_map(|above| directions.iter().map(move |&(zenith, azimuth)| View { zenith, azimuth, above }))
        .collect();
    let medium = Medium { g_forward: 0.8, g_back: -0.3, forward_share: 0.85, albedo };
    let mut seed = seed;
    for &tau in taus {
        for &sun in suns {
            seed += 1;
            let seen = follow(&medium, tau, sun, &views, photons, seed);
            for (view, [radiance, first, error]) in views.iter().zip(&seen.views) {
                let View { zenith, azimuth, above } = view;
                let above = u8::from(*above);
                println!(
                    "{albedo},{tau},{sun},{zenith},{azimuth},{above},{radiance:.5e},{first:.4e},{error:.1e}"
                );
            }
        }
    }
}
