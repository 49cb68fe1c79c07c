//! Tests of playing without a screen, in a single program because linking many takes longer than running them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod buttons;
mod choosing;
mod claims;
mod clock;
mod conditions;
mod controls;
mod counting;
mod dragging;
mod drawings;
mod ending;
mod history;
mod legends;
mod members;
mod plots;
mod profiles;
mod questions;
mod replacement;
mod scores;
mod seats;
mod sharing;
mod simulations;
mod sizes;
mod support;
mod surveys;
mod sweeps;
mod trails;
