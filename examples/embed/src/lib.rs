//! A small engine that is not written around Orogen: it has meshes, a camera, a shadow map and a depth buffer of its own, and
//! draws Orogen's landscape among them. `landscape.rs` is all that it has for Orogen's sake.

#![allow(missing_docs, reason = "an example: its names say what they are")]

pub mod camera;
pub mod engine;
pub mod landscape;
mod pipelines;
pub mod shot;
pub mod tower;
#[cfg(feature = "window")]
pub mod window;
pub mod world;
