//! Tests of the laboratory without a screen; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod answers;
mod anything;
mod clock;
mod controls;
mod cycles;
mod derived;
mod fits;
mod history;
mod intake;
mod reading;
mod records;
mod sharing;
mod simulations;
mod support;
mod understood;
mod undo;
