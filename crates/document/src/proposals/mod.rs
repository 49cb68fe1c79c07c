//! Claims that follow from the text of a document alone.
//!
//! [`propose`] reads the checked equations, evaluates them at [`Point`]s of a run and of its surroundings, and returns
//! [`Proposal`]s: lines of a check with a reason. What a proposal expects comes from one part of the text (the forces, the
//! linearised equations, the labels), and what it tests from another (an energy, a period, an initial value), so that it
//! fails where the two disagree. The caller runs proposals before it shows them: `runner::proposals`.
//!
//! [`KINDS`] lists all kinds. An author declines a proposal by a comment in a check block, `# declined KEY: reason`.

mod balance;
mod decay;
mod declined;
mod energy;
mod equilibrium;
mod kinds;
mod labels;
mod pattern;
mod period;
mod proposal;
mod rest;
mod signs;
mod start;
mod study;
mod sums;
mod terms;
mod untested;
mod written;

pub use declined::{Declined, declined};
pub use kinds::{KINDS, Kind};
pub use proposal::Proposal;
pub use study::{Evaluation, Point};
pub use untested::untested;

use crate::Document;
use study::Study;

/// Proposals for a document, kind after kind. `evaluation` gives values of expressions.
pub fn propose(document: &Document, evaluation: &dyn Evaluation) -> Vec<Proposal> {
    let Some(mut study) = Study::begin(&document.program, evaluation) else { return Vec::new() };
    let energies = energy::energies(&mut study);
    KINDS.iter().flat_map(|kind| (kind.derive)(&mut study, &energies)).collect()
}
