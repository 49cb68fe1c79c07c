//! Values over the members of families: `x[i] against i*a for i in 0..N+1`.

use super::curves;
use super::curves::Placed;
use crate::expressions::{Expressions, dimension_error};
use crate::text::scan::find_word;
use crate::text::source::trim;
use model::{Diagnostic, Name, Over, Span};
use program::{Members, NodeId};
use std::ops::{Range, RangeInclusive};
use units::{Words, words};

/// `for i in 0..N+1`, by places in the source.
#[derive(Clone, Debug)]
pub struct Index {
    name: Range<usize>,
    ends: Range<usize>,
}

/// What is computed of each member.
pub struct Read {
    /// The curve as it is shown, with the unit and the label of the first member that changes during a run.
    pub curve: Placed,
    /// The value of each member.
    pub nodes: Vec<NodeId>,
}

/// What stands before `for NAME in LOW..HIGH`, and that; none where a part does not end so.
pub fn find(source: &str, part: Range<usize>) -> Option<(Range<usize>, Index)> {
    let word = find_word(source, part.clone(), "for")?;
    let rest = trim(source, word.end..part.end);
    let length = source[rest.clone()].find(|letter: char| !(letter.is_alphanumeric() || letter == '_'))?;
    let name = rest.start..rest.start + length;
    let ends = source[name.end..rest.end].trim_start().strip_prefix("in")?;
    let is_index = length > 0 && ends.starts_with(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
    let before = trim(source, part.start..word.start);
    (is_index && !before.is_empty()).then(|| (before, Index { name, ends: rest.end - ends.len()..rest.end }))
}

/// Reads the values of an index. They are whole numbers that never change.
pub fn values(expressions: &mut Expressions, index: &Index) -> Option<RangeInclusive<i64>> {
    let source = expressions.source;
    let place = Span::new(index.name.start, index.name.end);
    let text = &source[index.name.clone()];
    if expressions.is_taken(text) {
        let message = words!("`{text}` has a meaning already", "`{text}` ya tiene un significado");
        expressions.diagnostics.push(
            Diagnostic::error("index-range", message, place)
                .with_hint(words("choose another name for the index", "elige otro nombre para el índice")),
        );
        return None;
    }
    let ends = trim(source, index.ends.clone());
    let Some(dots) = source[ends.clone()].find("..") else {
        return refuse(
            expressions,
            words("this is no range of an index", "esto no es un intervalo de un índice"),
            &ends,
        );
    };
    let name = Name { text: text.to_owned(), span: place };
    let (low, high) = (ends.start..ends.start + dots, ends.start + dots + 2..ends.end);
    let values = expressions.whole_range(name, low, high)?;
    let count = values.end().saturating_sub(*values.start()).saturating_add(1);
    if count < 1 {
        return refuse(expressions, words("the range is empty", "el intervalo está vacío"), &ends);
    }
    if count > Members::MOST as i64 {
        let most = Members::MOST;
        let message =
            words!("a plot cannot have more than {most} members", "una gráfica no puede tener más de {most} miembros");
        return refuse(expressions, message, &ends);
    }
    Some(values)
}

fn refuse<T>(expressions: &mut Expressions, message: Words, place: &Range<usize>) -> Option<T> {
    let span = Span::new(place.start, place.end);
    expressions.diagnostics.push(
        Diagnostic::error("index-range", message, span)
            .with_hint(words("write `for i in 1..10`", "escribe `for i in 1..10`")),
    );
    None
}

impl Expressions<'_> {
    /// Lets an index stand for a number in what is compiled until [`Self::release`].
    fn hold(&mut self, index: &str, value: i64) {
        self.compiler.bind(index, value);
    }

    /// Takes back the index that was held last.
    fn release(&mut self) {
        self.compiler.unbind();
    }

    /// The values of an index between two ends, both included, which are made of whole numbers and sizes.
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
            let message =
                words("the values of an index are pure numbers", "los valores de un índice son números puros");
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

/// Reads what stands in `range`, with its label, for each value of an index. All members have one dimension.
pub fn read(
    expressions: &mut Expressions,
    range: Range<usize>,
    index: &Index,
    values: RangeInclusive<i64>,
) -> Option<Read> {
    let name = expressions.source[index.name.clone()].to_owned();
    let mut nodes = Vec::new();
    let mut shown: Option<(Placed, bool)> = None;
    for value in values {
        expressions.hold(&name, value);
        let placed = curves::read(expressions, range.clone());
        expressions.release();
        // What is wrong with one member is wrong with all, or names the one.
        let placed = placed?;
        let found = (placed.span, placed.curve.value.dimension());
        let varies = expressions.model().depends(placed.curve.value.node).varies();
        nodes.push(placed.curve.value.node);
        match &shown {
            Some((first, _)) if first.curve.value.dimension() != found.1 => {
                let message = words!(
                    "not all members of `{}` have one dimension",
                    "no todos los miembros de `{}` tienen la misma dimensión",
                    first.curve.expression
                );
                let expected = first.curve.value.dimension();
                let mut diagnostic = dimension_error(message, found, (first.span, expected));
                // Both labels would lie on one another.
                let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
                expressions.diagnostics.push(diagnostic.with_note(words!(
                    "the first one is {expected}",
                    "el primero es {expected}",
                    expected = expected
                )));
                return None;
            }
            Some((_, true)) => {}
            Some((_, false)) if !varies => {}
            _ => shown = Some((placed, varies)),
        }
    }
    shown.map(|(curve, _)| Read { curve, nodes })
}
