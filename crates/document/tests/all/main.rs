//! Tests of documents; a single program, because linking several takes longer than running them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod arbitrary;
mod beginners;
mod bundles;
#[path = "../../../model/tests/all/common/catalogue.rs"]
mod catalogue;
mod checks;
mod drawings;
mod editing;
mod hostile;
mod independent;
mod mistakes;
mod open;
mod plot_forms;
mod reference;
mod remedies;
mod search;
mod simulations;
mod spanish;
mod surveys;
mod theories;
