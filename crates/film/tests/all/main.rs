//! Tests of films; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod boxes;
mod containers;
mod damaged_films;
mod elements;
mod support;
mod timing;
