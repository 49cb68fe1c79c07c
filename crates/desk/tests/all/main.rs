//! Tests of the laboratory without a screen; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod anything;
mod cycles;
mod derived;
mod films;
mod fits;
mod intake;
mod projects;
mod reading;
mod records;
mod saved;
mod support;
mod understood;
mod undo;
mod variable;
mod writing;
