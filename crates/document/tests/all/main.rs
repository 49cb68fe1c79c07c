//! Tests of documents; one program, since linking many takes longer than they do.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod arbitrary;
mod asked;
mod assist;
mod beginners;
mod bundles;
#[path = "../../../model/tests/all/common/catalogue.rs"]
mod catalogue;
mod checks;
mod drawing;
mod edit;
mod form;
mod format;
mod frames;
mod hostile;
mod independent;
mod open;
mod outline;
mod parts;
mod plot_forms;
mod reference;
mod remedies;
mod rename;
mod repeats;
mod scene;
mod simulations;
mod sketch;
mod spanish;
mod templates;
mod theories;
mod translating;
