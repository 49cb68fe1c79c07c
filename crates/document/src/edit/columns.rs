//! Alignment of columns in a model when one line is edited.

use super::Edit;
use model::Span;

/// Adjusts the blanks after an edit so that the rest of the line stays in its column. Only if there is space, and if blanks
/// or the ends of `others` show that the line is aligned.
pub(super) fn keeping_columns(source: &str, mut edit: Edit, others: impl Iterator<Item = Span>) -> Edit {
    let Some(follower) = Follower::of(source, edit.span) else { return edit };
    let (old, new) = (source[edit.span.range()].chars().count(), edit.text.chars().count());
    let spare = follower.blanks.saturating_sub(1);
    let own = edit.span;
    let is_aligned = || {
        let mut others = others.filter(|other| *other != own).filter_map(|other| Follower::of(source, other));
        spare > 0 || others.any(|other| other.column == follower.column)
    };
    if new > old {
        edit.span.end += spare.min(new - old);
    } else if is_aligned() {
        edit.text.extend(std::iter::repeat_n(' ', old - new));
    }
    edit
}

/// The text after an edited span on its line.
struct Follower {
    /// Number of blanks between.
    blanks: usize,
    /// Column at which it begins, in characters.
    column: usize,
}

impl Follower {
    /// The text after `piece`; `None` at the end of the line.
    fn of(source: &str, piece: Span) -> Option<Self> {
        let rest = &source[piece.end..];
        let blanks = rest.len() - rest.trim_start_matches(' ').len();
        if rest[blanks..].is_empty() || rest[blanks..].starts_with(['\r', '\n']) {
            return None;
        }
        let start = source[..piece.start].rfind('\n').map_or(0, |at| at + 1);
        Some(Self { blanks, column: source[start..piece.end + blanks].chars().count() })
    }
}
