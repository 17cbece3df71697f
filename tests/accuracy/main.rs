//! What the library's functions promise, measured on the GPU against `truth`: f64, written in Rust from the definitions.
//!
//! Every promise is a row: what was measured, and the bound that it must keep. A row that breaks its bound fails the test;
//! all rows together are `docs/accuracy.md`, which `cargo xtask accuracy` writes anew.
//!
//! The fragments are read from `wgsl/` as it stands on disk, so this binary can be run again after an edit of WGSL without
//! being built again.

#![cfg(feature = "render")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "these tests show their numbers")]

mod atmosphere;
mod clouds;
mod clouds_lit;
mod colour;
mod fractal;
mod geometry;
mod harness;
mod light;
mod march;
mod night;
mod noise;
mod noise_cells;
mod noise_flow;
mod noise_ranges;
mod phase;
mod planet;
mod projection;
mod sky_orders;
mod terrain;
mod trees;
mod volume;
mod water;
mod weather;
