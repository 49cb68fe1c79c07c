//! Hand-ins. A hand-in holds work and the values that follow from it ([`saved::hand_in`]). Because the same document, data
//! and seed give the same bits everywhere, the values can be computed again from the work and compared exactly.
//!
//! This shows that the values follow from the data. It does not show who measured the data or did the work.
//!
//! `desk::facts` gives the values that follow from a work, `saved::hand_in` holds them beside the work. `Recomputation` opens
//! the work in a desk of its own and computes them again, in slices where a page does it itself, from a `WorkOrder` in a
//! worker (`Calculator`). `compare` (`verdict.rs`) lists what differs by part, item and quantity. Facts have identifiers
//! (`saved::hand_in::quantity_text` has their words). `HandIn::open` reads a hand-in in each of its forms; a report is a page
//! that carries one (`saved::carried`), and all of it but the data is stated, by head, style sheets and sections. A fit is
//! repeated from its saved numbers both when the hand-in is made and when it is verified, so that the bits are equal.
//! `copies.rs` finds data that two hand-ins share.

mod copies;
mod difference;
pub mod documents;
mod files;
mod recomputation;
mod stated;
mod stretched;
mod verdict;

pub use copies::{Copied, Curve, Relation, copied, copies};
pub use desk::write_varied;
pub use difference::{BeyondLimit, Difference, GradeDifference};
pub use documents::DocumentDifference;
pub use files::{DataFile, FILM_START, film_hash, project_of_files};
pub use recomputation::Recomputation;
pub(crate) use recomputation::document_has_errors;
pub use verdict::{OtherBits, Verdict, compare, meaning};

use saved::hand_in::{HandIn, Sender};
use saved::project::Project;
use units::Words;

/// A hand-in of this work, and a sentence for each part that could not be restored, of which no values are stated. `made`:
/// time in milliseconds since 1970. The values are computed from the work at once;
/// [`Recomputation`] does it in slices.
///
/// # Errors
/// If the document of the work cannot be opened, or the sender states another seat than the work has.
pub fn hand_in_with_losses(work: Project, sender: Sender, made: u64) -> Result<(HandIn, Vec<Words>), Words> {
    let recomputation = Recomputation::complete(&work)?;
    let left_out = recomputation.left_out().cloned().collect();
    let sender = recomputation.seated(sender)?;
    let facts = recomputation.facts();
    Ok((HandIn::new(made, sender, work, facts), left_out))
}

/// A hand-in as [`hand_in_with_losses`], without the sentences; errors likewise.
///
/// # Errors
/// If the document of the work cannot be opened, or the sender states another seat than the work has.
pub fn hand_in(work: Project, sender: Sender, made: u64) -> Result<HandIn, Words> {
    Ok(hand_in_with_losses(work, sender, made)?.0)
}

/// Computes a hand-in again at once, and compares.
///
/// # Errors
/// If the document of the hand-in cannot be opened.
pub fn verify(hand_in: &HandIn) -> Result<Verdict, Words> {
    let recomputation = Recomputation::complete(&hand_in.work)?;
    let refused = recomputation.refused();
    Ok(compare(hand_in, &recomputation.facts(), refused))
}
