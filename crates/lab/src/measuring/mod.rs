//! Tab *Measure*: records from files and from the virtual camera, and their analysis.

mod cycles;
pub mod data;
mod derivatives;
pub mod drop;
pub mod files;
mod intake;
pub mod measurements;
mod records;
mod virtual_form;
