//! Runs a model: virtual machine, methods, events, history.

mod error;
mod history;
mod instruction;
mod linear;
mod method;
mod readings;
mod routine;
mod run;
mod setup;
pub mod table;

pub use error::RunError;
pub use history::History;
pub use method::{Method, UnknownMethod};
pub use readings::Readings;
pub use routine::Routine;
pub use run::{Advance, CAPACITY, Run};
pub use setup::Setup;
