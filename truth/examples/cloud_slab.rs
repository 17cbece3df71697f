//! Prints `tests/accuracy/cloud_slab.csv`: radiance of cloud slabs, all orders. Some minutes.

#![allow(clippy::print_stdout, reason = "it prints a table")]

use truth::cloud_slab::{Medium, View, follow};

fn main() {
    let photons = std::env::args().nth(1).map_or(250_000, |text| text.parse().expect("how many photons"));
    println!("albedo,tau,sun_zenith,view_zenith,view_azimuth,above,radiance,first_order,standard_error");
    let mut views = Vec::new();
    for above in [true, false] {
        for (zenith, azimuth) in
            [(0.0, 0.0), (30.0, 90.0), (45.0, 0.0), (60.0, 180.0), (60.0, 0.0), (75.0, 60.0)]
        {
            views.push(View { zenith, azimuth, above });
        }
    }
    let mut seed = 1;
    for (albedo, depths) in [(1.0, &[0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0][..]), (0.9, &[2.0, 16.0][..])]
    {
        let medium = Medium { g_forward: 0.8, g_back: -0.3, forward_share: 0.85, albedo };
        for &tau in depths {
            for sun_zenith in [0.0, 30.0, 60.0, 80.0] {
                seed += 1;
                let seen = follow(&medium, tau, sun_zenith, &views, photons, seed);
                for (view, [radiance, first, error]) in views.iter().zip(&seen.views) {
                    let above = u8::from(view.above);
                    let (zenith, azimuth) = (view.zenith, view.azimuth);
                    println!(
                        "{albedo},{tau},{sun_zenith},{zenith},{azimuth},{above},{radiance:.5e},{first:.4e},{error:.1e}"
                    );
                }
            }
        }
    }
}
