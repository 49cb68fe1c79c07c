//! Tests of the class, linked as one test program.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod against;
mod collection;
mod copies;
mod course;
mod documents;
mod files;
mod forged;
mod grades;
mod honest;
mod pooling;
mod reports;
mod results;
mod secrets;
mod support;
mod survey;
mod verify;
