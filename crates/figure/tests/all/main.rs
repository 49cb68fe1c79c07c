//! Tests of figures; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod arbitrary;
mod cloud;
mod gestures;
mod layout;
mod lines;
mod survey;
mod svg;
