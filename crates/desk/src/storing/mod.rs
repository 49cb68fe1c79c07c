//! Data stored for the next visit: conversion between a desk and items ([`saved::Item`]), and a visit of a page with its
//! storage.

mod answers;
mod fact_list;
mod facts;
mod films;
mod fit_facts;
mod fits;
mod place;
mod project;
mod records;
mod tracks;
mod visit;

pub use fits::write_varied;
pub use visit::{Visit, document_data};
