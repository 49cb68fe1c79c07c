//! Tests of films; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod containers;
mod damaged_films;
mod support;
mod timing;
