//! Simulation engine: a register machine for the equations, integration methods, events, the recorded history, and the checks
//! of an author's claims.
//!
//! [`Run`] advances with a [`Method`], locates events and records a `History`; [`Stepper`] is the same without a record.
//! [`table`] gives the rows of a run and writes them as CSV; [`csv`] writes CSV for programs and for spreadsheets with
//! decimal points or commas. What a run cannot promise is a [`Notice`]: an event that may be skipped, a table that was left
//! (`record/ranges.rs`), a step with which the method is unstable (`methods/stability.rs`, by power iteration every 256
//! rows). A failed run is a [`RunError`]: a [`Cause`] with indices of states, parameters or events, and a time.
//!
//! | module | content |
//! |---|---|
//! | `code` | [`Routine`]: register code for nodes of the graph |
//! | `methods` | methods, their linear algebra, the stepper |
//! | `events` | events, switches, timed changes, and where within a step they are looked for |
//! | `record` | history, tables, readings, folds, checkpoints |
//! | `compiled` | steps that are made outside of the engine, alone and side by side |
//! | [`checks`] | claims of a document about its runs |
//!
//! - **Invariant:** two runs of one program with the same inputs have the same bits, natively and in the browser. Elementary
//!   functions come from `elementary` and `libm`; `clippy.toml` forbids those of the standard library.
//! - **Invariant:** row times are `t_0 + n h`, never summed. The size of the history is bounded ([`CAPACITY`], 64 MiB).
//! - **Invariant:** a run can be divided into portions of work ([`Run::advance_within`]) and continued from any row of its
//!   grid ([`Run::truncate`]) without a change in its bits. Work is counted in floating-point operations, because one row of
//!   a stiff model can take many steps. [`AfterJump`] records what the state alone does not contain after a jump. Adaptive
//!   methods repeat the steps since the last checkpoint (`record/checkpoints.rs`).
//! - **Invariant:** the state at an event is one that the method gives for a shorter step from the same start, never an
//!   interpolated one. It is the last state at which the condition is false (`events`).
//! - **Invariant:** within a step the equations are smooth. What jumps or bends in them ([`program::Model::held`]) keeps its
//!   value during the step, and the step ends where the true value changes (`events`).

pub mod checks;
mod code;
mod compiled;
mod error;
mod events;
mod methods;
mod notice;
mod record;
mod run;
mod setup;
mod start;
mod wide;

pub use code::instruction::{Operation, Register};
pub use code::lines::Line;
pub use code::routine::Routine;
pub use compiled::lanes::{LanesLayout, LanesListing};
pub use compiled::layout::Layout;
pub use compiled::listing::{Formulas, Interpreted, Listing, Preparation, WindowListing};
pub use compiled::preparing::side_by_side;
pub use compiled::side_by_side::{LANES, SideBySide};
pub use compiled::window_layout::WindowLayout;
pub use compiled::{Compiled, Compiler};
pub use error::{Cause, RunError, Subject};
pub use events::interpolant::{CHECKS, certain_sign_changes, sign_changes};
pub use events::press::Press;
pub use methods::adaptive::{StepControl, dormand_prince_growth, dormand_prince_shrinkage};
pub use methods::cubic::cubic_value;
pub use methods::last_step::LastStep;
pub use methods::stepper::{Progress, ROUNDING, Reached, Stepper, rows_until};
pub use methods::tableau;
pub use notice::{Notice, NoticeKind};
pub use program::Method;
pub use record::folds::Folds;
pub use record::history::History;
pub use record::readings::Readings;
pub use record::{AfterJump, Record};
pub use record::{csv, table};
pub use run::{Advance, CAPACITY, Run};
pub use setup::Setup;
pub use wide::{Wide, dot, run_wide, subtract_multiple};
