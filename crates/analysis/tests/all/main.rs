//! Tests of measured data: tables, import, cycles and fits. They are one program, because linking many takes longer than
//! running them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod cycle_drifts;
mod cycle_errors;
mod cycles;
mod data_sets;
mod derivatives;
mod device_variants;
mod devices;
mod estimate;
mod fits;
mod headings;
mod import;
mod import_limits;
mod import_properties;
mod old_workbooks;
mod percentages;
mod roles;
mod runs_and_clocks;
mod spreadsheets;
mod support;
mod traces;
mod tracker;
mod tracker_variants;
mod understood;
mod variants;
mod workbooks;
