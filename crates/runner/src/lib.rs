//! A document with settings in, a table out: what the command line and other programs share.
//!
//! [`Loaded`] opens a document with its translations, [`setup`] turns [`Settings`] into the setup of a run, and [`follow`] makes
//! it. A [`Plan`] says with which parameters many runs are made; a [`Sweep`] computes them on all processors, in the order of the
//! plan and with the same bits on any number of processors. [`fitting`] fits documents to [`records`]; [`page`] makes a page that plays a
//! document.

mod axes;
mod claims;
mod course;
mod drawn;
pub mod fitting;
pub mod names;
mod opening;
pub mod page;
mod plan;
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
pub use opening::{Files, Loaded, Sources, decoded, sources, text_of};
pub use plan::{Axis, Plan, PlanError, Points, Values};
pub use quoted::quoted;
pub use refusal::{Refusal, listed, plain};
pub use settings::{Settings, no_seats, setup, take_seat};
pub use sweep::{Sweep, SweepCode, Taken, threads, use_threads};
pub use sweeping::{kept, plan};
pub use table::{ColumnValues, Table, TableColumn, chosen_columns};
pub use values::{Reader, positive, within_range};
