//! A document with settings in, a table out: what the command line and the Python package share, so that both give the same
//! numbers and the same messages.
//!
//! [`Loaded`] opens a document with its translations, from files that the caller reads ([`Files`]). [`setup`] turns
//! [`Settings`], texts as a person types them, into the setup of a run, and [`follow`] makes it row by row; [`Table`]
//! collects the rows in declared units. [`records`] reads measured data with what is stated about their columns, and
//! [`fitting`] fits and ranks documents and writes the results as JSON and as text. [`page`] makes a page that plays a
//! document. A [`Refusal`] is a message with a remedy, or the diagnostics of a text in a setting; the caller prints or raises
//! it.
//!
//! Many runs: a [`Plan`] says with which parameters (all combinations of lists and ranges, random ones, or a sequence of
//! Halton). The values of a run follow from its number alone, so that a plan can be divided into shares. A [`Sweep`] computes
//! runs on all processors (`rayon`), side by side where the model has lanes, and gives what is taken of each in the order of
//! the plan. What is taken is compiled by `document::outcomes`; aggregates of a run ([`engine::Folds`]) are those of plots
//! over a parameter.
//!
//! - **Invariant:** no arguments, no terminal, no files. Messages name settings as options of the command line, which Python
//!   spells as keywords.
//! - **Invariant:** a row has the bits of a single run with its parameters, on any number of processors and in any share.

mod axes;
mod claims;
mod course;
mod drawn;
pub mod fitting;
mod keywords;
pub mod names;
mod opening;
pub mod page;
mod plan;
mod proposals;
mod quoted;
pub mod records;
mod refusal;
mod settings;
mod sweep;
mod sweeping;
mod table;
mod values;

pub use axes::axis;
pub use claims::{JudgedClaim, judged};
pub use course::{follow, place, steps};
pub use drawn::draw;
pub use keywords::in_keywords;
pub use opening::{Files, Loaded, Sources, decoded, sources, text_of};
pub use plan::{Axis, Plan, PlanError, Points, Values};
pub use proposals::{JudgedProposal, Proposed, proposed};
pub use quoted::quoted;
pub use refusal::{Refusal, listed, plain};
pub use settings::{Settings, no_seats, setup, take_seat};
pub use sweep::{Sweep, SweepCode, Taken, threads, use_threads};
pub use sweeping::{kept, plan};
pub use table::{ColumnValues, Table, TableColumn, chosen_columns};
pub use values::{Reader, positive, within_range};
