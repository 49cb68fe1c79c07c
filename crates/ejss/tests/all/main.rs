//! Tests of the import, linked as one program.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod encodings;
mod golden;
mod hostile;
mod motions;
mod support;
