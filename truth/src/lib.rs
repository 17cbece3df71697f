//! The library's functions in f64, written from their definitions and not from the WGSL: the truth that the GPU's values are
//! held against.
//!
//! Inputs are the `f32` values that the GPU gets, widened: what is measured is the error of the arithmetic, not of the
//! input. Hashes are the same integers on both sides.

pub mod cloud_slab;
pub mod clouds;
pub mod erosion;
pub mod fractal;
pub mod geometry;
pub mod hash;
pub mod light;
pub mod march;
pub mod noise;
pub mod oklab;
pub mod phase;
pub mod points;
pub mod spectrum;
pub mod trees;
pub mod volume;
