//! Values over the members of families: `x[i] against i*a for i in 0..N+1`.

use super::curves;
use super::curves::Placed;
use crate::expressions::{Expressions, dimension_error};
use model::{Diagnostic, Name, Operand, Over, Phrase, Span};
use program::{Members, NodeId};
use std::ops::{Range, RangeInclusive};
use units::{Words, words};

/// `for i in 0..N+1`.
#[derive(Clone, Copy, Debug)]
pub struct Index {
    name: Span,
    ends: Operand,
}

/// Values of all members.
pub struct Read {
    /// The curve as shown, with the unit and the label of the first member that varies during a run.
    pub curve: Placed,
    /// Node of each member's value.
    pub nodes: Vec<NodeId>,
}

/// Splits a part into the phrase before `for NAME in LOW..HIGH` and that index. `None` if the part has no such end.
pub fn find(part: Phrase) -> Option<(Phrase, Index)> {
    let over = part.split_last(&["for"])?;
    let range = over.after.split_first("in")?;
    let (name, ends) = (range.before.operand, Operand { span: range.after.span(), ..range.after.operand });
    let is_index =
        name.is_word && range.before.clauses.is_empty() && !over.before.is_empty() && !range.after.is_empty();
    is_index.then_some((over.before, Index { name: name.span, ends }))
}

/// Values of an index: constant integers.
pub fn values(expressions: &mut Expressions, index: Index) -> Option<RangeInclusive<i64>> {
    let source = expressions.source;
    let place = index.name;
    let text = &source[index.name.range()];
    if expressions.is_taken(text) {
        let message = words!("`{text}` has a meaning already");
        expressions.diagnostics.push(
            Diagnostic::error("index-range", message, place).with_hint(words("choose another name for the index")),
        );
        return None;
    }
    let ends = index.ends.span;
    let Some(dots) = index.ends.dots else {
        return refuse(expressions, words("this is no range of an index"), ends);
    };
    let name = Name { text: text.to_owned(), span: place };
    let values = expressions.whole_range(name, ends.start..dots.start, dots.end..ends.end)?;
    let count = values.end().saturating_sub(*values.start()).saturating_add(1);
    if count < 1 {
        return refuse(expressions, words("the range is empty"), ends);
    }
    if count > Members::MOST as i64 {
        let most = Members::MOST;
        let message = words!("a plot cannot have more than {most} members");
        return refuse(expressions, message, ends);
    }
    Some(values)
}

fn refuse<T>(expressions: &mut Expressions, message: Words, span: Span) -> Option<T> {
    expressions
        .diagnostics
        .push(Diagnostic::error("index-range", message, span).with_hint(words("write `for i in 1..10`")));
    None
}

impl Expressions<'_> {
    /// Binds an index to a value in what is compiled until [`Self::release`].
    fn hold(&mut self, index: &str, value: i64) {
        self.compiler.bind(index, value);
    }

    /// Removes the last binding.
    fn release(&mut self) {
        self.compiler.unbind();
    }

    /// Values of an index between two ends, both included; the ends consist of integers and sizes.
    fn whole_range(&mut self, index: Name, low: Range<usize>, high: Range<usize>) -> Option<RangeInclusive<i64>> {
        let before = self.diagnostics.len();
        let mut end = |range: Range<usize>| {
            let (expression, unit, found) = model::parse_expression(self.source, range);
            self.diagnostics.extend(found);
            unit.is_none().then_some(expression)
        };
        let (low, high) = (end(low), end(high));
        let span = index.span;
        let Some((low, high)) = low.zip(high) else {
            let message = words("the values of an index are pure numbers");
            self.error("index-range", message, span);
            return None;
        };
        if self.diagnostics.len() > before {
            return None;
        }
        match self.compiler.range(&Over { index, low, high }) {
            Ok(values) => Some(values),
            Err(diagnostic) => {
                self.diagnostics.push(*diagnostic);
                None
            }
        }
    }
}

/// Compiles a phrase, with its label, for each value of an index. All members must have one dimension.
pub fn read(expressions: &mut Expressions, phrase: Phrase, index: Index, values: RangeInclusive<i64>) -> Option<Read> {
    let name = expressions.source[index.name.range()].to_owned();
    let mut nodes = Vec::new();
    let mut shown: Option<(Placed, bool)> = None;
    for value in values {
        expressions.hold(&name, value);
        let placed = curves::read(expressions, phrase);
        expressions.release();
        // An error of one member occurs in all, or names the member.
        let placed = placed?;
        let found = (placed.span, placed.curve.value.dimension());
        let varies = expressions.model().depends(placed.curve.value.node).varies();
        nodes.push(placed.curve.value.node);
        match &shown {
            Some((first, _)) if first.curve.value.dimension() != found.1 => {
                let message = words!("not all members of `{}` have one dimension", first.curve.expression);
                let expected = first.curve.value.dimension();
                let mut diagnostic = dimension_error(message, found, (first.span, expected));
                // Both labels would be at the same place.
                let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
                expressions.diagnostics.push(diagnostic.with_note(words!("the first one is {expected}")));
                return None;
            }
            Some((_, true)) => {}
            Some((_, false)) if !varies => {}
            _ => shown = Some((placed, varies)),
        }
    }
    shown.map(|(curve, _)| Read { curve, nodes })
}
