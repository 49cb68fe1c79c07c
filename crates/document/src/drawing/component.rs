//! Components of points in the source text.

use crate::scene::pairs;
use model::Span;
use std::ops::Range;

/// Component of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// First component, to the right.
    Across,
    /// Second component: upwards in a frame, downwards outside.
    Along,
}

/// Byte ranges of the two components of a point: those of its pair without a factor. `None` if there is no such pair.
pub(crate) fn components(source: &str, value: Span) -> Option<(Range<usize>, Range<usize>)> {
    let range = crate::text::source::trim(source, value.range());
    let pairs = pairs(source, range.clone())?;
    let is_plain = |pair: &Range<usize>| {
        let before = source[range.start..pair.start].trim_end();
        let behind = source[pair.end..range.end].trim_start();
        (before.is_empty() || before.ends_with('+')) && !behind.starts_with(['*', '/'])
    };
    let pair = pairs.into_iter().find(|pair| is_plain(&pair.whole))?;
    Some((pair.first, pair.second))
}

/// Byte range of one component of a point.
pub(crate) fn at_axis(source: &str, value: Span, axis: Axis) -> Option<Range<usize>> {
    let (across, along) = components(source, value)?;
    let range = match axis {
        Axis::Across => across,
        Axis::Along => along,
    };
    Some(crate::text::source::trim(source, range))
}

/// Quantity that one component of a point follows: its name, if the component is that name alone or with a distance added;
/// an empty text if it is constant; `None` for another expression.
pub fn follows(source: &str, value: Span, axis: Axis) -> Option<&str> {
    let text = source.get(at_axis(source, value, axis)?)?;
    let (name, _) = crate::edit::split_distance(text);
    let is_name = name.chars().all(|letter| letter.is_alphanumeric() || matches!(letter, '_' | '\'' | '.'));
    (is_name && !name.starts_with(|letter: char| letter.is_ascii_digit())).then_some(name)
}
