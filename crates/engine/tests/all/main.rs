//! Tests of runs; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod buttons;
mod chance;
mod closed_forms;
mod drawn;
mod ends;
mod events;
mod families;
mod friction;
mod going_on;
mod guards;
mod large;
mod maps;
mod orders;
mod remembered;
mod runs;
mod sensitivities;
mod skipped;
mod so_far;
mod support;
mod switches;
mod tables;
mod tabulated;
mod unstable;
mod vectors;
mod work;
