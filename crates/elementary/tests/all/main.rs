//! Tests of the elementary functions.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod exact;
mod lanes;
mod special;
mod table;
