//! The library's functions in f64, written from their definitions and not from the WGSL: the truth that the GPU's values are
//! held against.
//!
//! Inputs are the `f32` values that the GPU gets, widened: what is measured is the error of the arithmetic, not of the
//! input. Hashes are the same integers on both sides.

pub mod hash;
pub mod march;
pub mod points;
