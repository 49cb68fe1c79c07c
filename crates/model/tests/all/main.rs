//! Tests of the equation language; a single program, because linking several takes longer than running them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod at_the_start;
mod bounds;
mod choices;
mod common;
mod derivatives;
mod errors;
mod expressions;
mod functions;
mod lowering;
mod properties;
mod sentences;
mod spanish;
mod syntax_errors;
mod syntax_properties;
mod turns;
mod vectors;
