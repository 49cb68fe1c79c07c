//! Hand-ins. A hand-in holds work and the values that follow from it ([`saved::hand_in`]). Because the same document, data
//! and seed give the same bits everywhere, the values can be computed again from the work and compared exactly.
//!
//! This shows that the values follow from the data. It does not show who measured the data or did the work.

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
