//! Proposals that an author has declined, with the reason.

use crate::text::block::BlockKind;
use crate::text::outline::Outline;

/// Beginning of the comment that declines a proposal.
const DECLINED: &str = "# declined ";

/// A declined proposal: `# declined energy E: the support does work`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declined {
    /// Key of the proposal.
    pub key: String,
    /// Reason of the author.
    pub reason: String,
}

/// The proposals declined by comments in the check blocks of a document.
pub fn declined(source: &str) -> Vec<Declined> {
    let outline: Outline = crate::read(source);
    let blocks = outline.blocks_of(BlockKind::Check).map(|block| &source[block.content.range()]);
    let lines = blocks.flat_map(str::lines);
    let declined = lines.filter_map(|line| line.trim().strip_prefix(DECLINED)?.split_once(':'));
    declined.map(|(key, reason)| Declined { key: key.trim().to_owned(), reason: reason.trim().to_owned() }).collect()
}
