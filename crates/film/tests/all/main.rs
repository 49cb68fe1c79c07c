//! The tests of films, on pictures that are formulas of place and time.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod bodies;
mod calibration;
mod columns;
mod scenes;
mod support;
mod y4m;
