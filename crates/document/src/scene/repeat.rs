//! Copies of an element for each value of an index, and computed lists of points: `i in 1..N`.

use super::builder::Builder;
use super::quantity::COPIES;
use super::space::points;
use model::{Expression, ExpressionKind, Span};
use program::Piece;
use std::ops::Range;
use units::words;

/// Maximum number of points of a computed line.
const POINTS: i64 = 500;
/// Number of pieces of a curve.
const PIECES: u32 = 100;

/// `i in 1..N`, as byte ranges in the source.
#[derive(Clone, Debug)]
pub struct Index {
    name: Range<usize>,
    low: Range<usize>,
    high: Range<usize>,
}

impl Builder<'_, '_> {
    /// Index of a repeated element, and its values.
    pub fn copies(&mut self, range: Range<usize>) -> Option<(Index, Range<i64>)> {
        let index = self.index(range.clone())?;
        let Some(values) = self.whole_values(&index) else {
            self.refuse(
                words("the ends of an index must be whole numbers that never change"),
                range,
                Some(words("write `i in 1..10`")),
            );
            return None;
        };
        let count = usize::try_from(values.end.saturating_sub(values.start)).unwrap_or(0);
        if !self.quantity.copy(count) {
            self.refuse(words!("the elements of a scene cannot have more than {COPIES} copies"), range, None);
            return None;
        }
        Some((index, values))
    }

    /// Binds the index to a number until [`Self::release`].
    pub fn hold(&mut self, index: &Index, value: i64) {
        let span = Span::new(index.name.start, index.name.end);
        let kind = ExpressionKind::Number { value: value as f64, unit: None };
        self.bind(index, Expression { kind, span });
    }

    fn bind(&mut self, index: &Index, value: Expression) {
        let name = self.source(&index.name).to_owned();
        self.expressions.bind(name, Some(value));
    }

    /// Removes the binding of the index.
    pub fn release(&mut self, index: &Index) {
        let name = self.source(&index.name).to_owned();
        self.expressions.bind(name, None);
    }

    /// `(i*a, x) for i in 0..10`: one point per integer, or a curve of [`PIECES`] pieces if the ends are not integers.
    /// `None` if the text has another form.
    pub fn computed_points(&mut self, range: Range<usize>) -> Option<Option<Vec<Piece>>> {
        let (point, rest) = self.source(&range).split_once(" for ")?;
        let point = range.start..range.start + point.len();
        let rest = range.end - rest.len()..range.end;
        Some(self.points_for(point, rest))
    }

    fn points_for(&mut self, point: Range<usize>, rest: Range<usize>) -> Option<Vec<Piece>> {
        let index = self.index(rest.clone())?;
        let mut pieces = Vec::new();
        if let Some(values) = self.whole_values(&index) {
            if values.end.saturating_sub(values.start) > POINTS {
                let message = words!("a line cannot have more than {POINTS} points");
                self.refuse(message, rest, None);
                return None;
            }
            for value in values {
                self.hold(&index, value);
                let spot = self.point(point.clone());
                self.release(&index);
                self.write_spot(spot?, &mut pieces);
            }
        } else {
            for number in 0..=PIECES {
                let value = self.expressions.part_of(
                    index.low.clone(),
                    index.high.clone(),
                    f64::from(number) / f64::from(PIECES),
                );
                self.bind(&index, value?);
                let spot = self.point(point.clone());
                self.release(&index);
                self.write_spot(spot?, &mut pieces);
            }
        }
        self.fits(pieces.len(), rest).then(|| super::space::shapes::merged(pieces))
    }

    /// Splits `i in 1..N`.
    fn index(&mut self, range: Range<usize>) -> Option<Index> {
        let range = crate::text::source::trim(self.expressions.source, range);
        let text = self.source(&range);
        let parts = text.split_once(" in ").map(|(name, rest)| (name.len(), rest.len()));
        let parts = parts.and_then(|(name, rest)| {
            let name = crate::text::source::trim(self.expressions.source, range.start..range.start + name);
            let (low, high) = points::interval(self.expressions.source, &(range.end - rest..range.end))?;
            let text = self.source(&name);
            let is_name = text.starts_with(|c: char| c.is_ascii_alphabetic())
                && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            is_name.then_some(Index { name, low, high })
        });
        let Some(index) = parts else {
            self.refuse(
                words("an index is a name and its first and last value"),
                range,
                Some(words("write `i in 1..10`")),
            );
            return None;
        };
        let name = self.source(&index.name).to_owned();
        if self.expressions.is_taken(&name) {
            self.refuse(
                words!("`{name}` has a meaning already"),
                index.name,
                Some(words("choose another name for the index")),
            );
            return None;
        }
        Some(index)
    }

    /// Values of an index, if its ends are constant integers.
    fn whole_values(&mut self, index: &Index) -> Option<Range<i64>> {
        let before = self.expressions.diagnostics.len();
        let (low, high) = (self.expressions.number(index.low.clone()), self.expressions.number(index.high.clone()));
        if self.expressions.diagnostics.len() > before {
            return None;
        }
        let (low, high) = low.zip(high)?;
        let mut whole = |placed: &crate::expressions::Placed| {
            let value = self.graph().as_constant(placed.value.node)?;
            let is_whole = placed.value.dimension().is_none() && value == value.floor() && value.abs() < 1e6;
            is_whole.then_some(value as i64)
        };
        let (low, high) = (whole(&low)?, whole(&high)?);
        Some(low..high + 1)
    }
}
