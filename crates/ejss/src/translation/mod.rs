//! Translation of plain models: one system of ordinary differential equations with single values.
//!
//! Code is executed symbolically (`run.rs`): which value each variable has behind a page, as an expression, so that order,
//! `if` and `+=` come out as they act. Phases differ in what a name means: at the start, in a rate, in a fixed relation, in
//! an event. What has no value carries the reason with its place, and so does everything that needs it. Where the states need
//! it, the simulation is listed and not translated.

mod blocker;
mod branches;
mod calls;
mod choices;
mod controls;
mod evaluation;
mod events;
mod facts;
mod lagging;
mod method;
mod model;
mod motion;
mod names;
mod needs;
mod picture;
mod plots;
mod remembering;
mod run;
mod solved;
mod units;
mod value;
mod writing;

pub(crate) use blocker::Blocker;
pub(crate) use facts::active_equations;
pub(crate) use method::method_of;
pub(crate) use picture::is_drawn;
pub(crate) use plots::is_trail;
pub(crate) use solved::{Document, Solved};
