//! Runs a model: virtual machine, methods, events, history; and judges what its author claims about runs.

mod adaptive;
mod checkpoints;
pub mod checks;
mod code;
mod column;
mod columns;
mod compile;
mod crossing;
pub mod csv;
mod cubic;
mod dormand_prince;
mod equations;
mod error;
mod events;
mod fixed;
mod history;
mod instruction;
mod jumps;
mod linear;
mod looks;
mod notice;
#[cfg(test)]
mod order_conditions;
mod readings;
mod record;
mod rosenbrock;
mod routine;
mod run;
mod setup;
mod start;
mod stepper;
mod surfaces;
mod switches;
pub mod table;
mod timetable;

pub use error::{Cause, RunError, Subject};
pub use history::History;
pub use notice::{Notice, NoticeKind};
pub use program::Method;
pub use readings::Readings;
pub use record::{AfterJump, Record};
pub use routine::Routine;
pub use run::{Advance, CAPACITY, Run};
pub use setup::Setup;
pub use stepper::{Progress, Stepper};
