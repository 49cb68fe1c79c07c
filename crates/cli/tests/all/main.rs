//! Tests that run the program from outside, linked as one test program because linking many takes longer than the
//! tests.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod accuracy;
mod authoring;
#[cfg(page_inside)]
mod build;
mod carried;
mod check;
mod class_store;
mod common;
mod cycles;
mod derivatives;
mod fit;
mod fit_options;
mod guide;
mod handing;
mod import;
mod lsp;
mod mcp;
mod office;
mod pages;
mod projects;
mod rank;
mod roles;
mod run;
mod seats;
mod strangers;
mod surveys;
mod sweep;
mod track;
mod turns;
