//! Emitted code gives the bits of the interpreter.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod documents;
mod host;
