//! Fits of models to data with known results.
#![allow(clippy::unwrap_used, reason = "a test fails by it")]

mod classic;
mod coverage;
mod elsewhere;
mod judged;
mod known;
mod nist;
#[path = "../support/mod.rs"]
mod noise;
mod parts;
mod robust;
mod support;
mod utube;
