//! Tests of the laboratory without a screen, linked as one program because linking many takes longer than the tests.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod anything;
mod cycles;
mod derived;
mod films;
mod fits;
mod intake;
mod opened;
mod projects;
mod reading;
mod records;
mod saved;
mod shared_units;
mod support;
mod turns;
mod understood;
mod undo;
mod variable;
mod writing;
