//! Tests of films, on small films and on pictures that are formulas of place and time; one program, since linking many takes
//! longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod agreement;
mod bodies;
mod boxes;
mod calibration;
mod camera;
mod capacity;
mod columns;
mod containers;
mod cut_avi;
mod damaged_films;
mod disturbed_columns;
mod elements;
mod repeats;
mod scenes;
#[expect(dead_code, reason = "the example `bodies` draws all kinds")]
mod stage;
mod staged;
mod support;
mod timing;
mod tubes;
mod y4m;
