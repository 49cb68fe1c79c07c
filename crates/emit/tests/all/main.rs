//! Emitted code gives the bits of the interpreter.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod arbitrary;
mod compare;
mod documents;
mod fits;
#[path = "../../../engine/tests/all/guards/models.rs"]
mod guarded;
mod guards;
mod host;
mod programs;
