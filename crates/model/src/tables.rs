//! Functions defined by a table: `table eta(T) in [mPa s] { 273 [K] 1.792  293 1.002 }`.

use crate::{Diagnostic, DrawnRange, Point, Span, StatedUnit, TableStatement, limits};
use program::{Drawn, Interpolation};
use std::cmp::Ordering;
use std::sync::Arc;
use units::{Dimension, words};

/// A checked table, as expressions use it.
#[derive(Clone, Debug)]
pub(crate) struct TableFunction {
    /// Name of its argument.
    pub argument_name: String,
    /// Dimension of its argument.
    pub argument: Dimension,
    /// Dimension of its values.
    pub value: Dimension,
    pub interpolation: Arc<Interpolation>,
    /// The curve that the reader may draw; `None` if the table cannot be drawn.
    pub drawn: Option<Drawn>,
    /// Place of the unit of its argument, or else of the argument's name.
    pub span: Span,
}

impl TableStatement {
    /// The table with this index, with points in SI units. `None` after an error in its points or its range.
    pub(crate) fn checked(&self, number: usize, diagnostics: &mut Vec<Diagnostic>) -> Option<TableFunction> {
        let si = |unit: &Option<StatedUnit>, value| unit.as_ref().map_or(value, |stated| stated.unit.to_si(value));
        let point = |point: &Point| [si(&self.argument_unit, point.x), si(&self.unit, point.y)];
        let points: Vec<[f64; 2]> = self.points.iter().map(point).collect();
        if let Some(range) = &self.drawn
            && let Some(found) = self.undrawable(range)
        {
            diagnostics.push(found);
            return None;
        }
        let given = Interpolation::through_points(self.course, &points).filter(|_| points.len() > 1);
        let interpolation = match &self.drawn {
            Some(_) if points.is_empty() => Some(None),
            _ => given.map(Some),
        };
        match interpolation {
            Some(given) => {
                let drawn = self.drawn.as_ref().map(|range| self.drawn_from(range, given.as_ref()));
                let interpolation = match &drawn {
                    Some(drawn) => drawn.curve(&drawn.values)?.drawn(number as u32),
                    None => given?,
                };
                let dimension =
                    |unit: &Option<StatedUnit>| unit.as_ref().map_or(Dimension::NONE, |unit| unit.unit.dimension);
                Some(TableFunction {
                    argument_name: self.argument.text.clone(),
                    argument: dimension(&self.argument_unit),
                    value: dimension(&self.unit),
                    interpolation: Arc::new(interpolation),
                    drawn,
                    span: self.argument_unit.as_ref().map_or(self.name.span, |unit| unit.span),
                })
            }
            None => {
                diagnostics.push(self.disorder());
                None
            }
        }
    }

    /// Error in the range of a drawn curve, or `None`.
    fn undrawable(&self, range: &DrawnRange) -> Option<Diagnostic> {
        let DrawnRange { bounds, from, until, until_span } = range;
        let (low, high, name) = (bounds.low, bounds.high, &self.name.text);
        if !(low < high && low.is_finite() && high.is_finite()) {
            let message = words!("nothing can be drawn for `{name}`: {low} is not less than {high}");
            let diagnostic = Diagnostic::error("empty-range", message, bounds.span);
            return Some(if low > high {
                diagnostic.with_hint(words!("write `drawn in {high}..{low}`"))
            } else {
                diagnostic
            });
        }
        if !(from < until && from.is_finite() && until.is_finite()) {
            let message = words!("nothing can be drawn for `{name}`: it ends at {until}, not after {from}");
            return Some(Diagnostic::error("empty-range", message, *until_span));
        }
        let point = self.points.iter().find(|point| !(low..=high).contains(&point.y))?;
        let message = words!("the value {} lies outside the range {low}..{high} in which `{name}` is drawn", point.y);
        Some(Diagnostic::error("default-out-of-range", message, point.span).with_label(bounds.span, words("the range")))
    }

    /// The drawn curve with the values of a given curve, or 0 without one, clamped to its range. SI units.
    fn drawn_from(&self, range: &DrawnRange, given: Option<&Interpolation>) -> Drawn {
        let si = |unit: &Option<StatedUnit>, value| unit.as_ref().map_or(value, |stated| stated.unit.to_si(value));
        let mut drawn = Drawn {
            low: si(&self.unit, range.bounds.low),
            high: si(&self.unit, range.bounds.high),
            from: si(&self.argument_unit, range.from),
            until: si(&self.argument_unit, range.until),
            course: self.course,
            values: Vec::new(),
        };
        let value = |point| {
            let argument = drawn.argument(point);
            let value = given.map_or(0.0, |given| given.value(argument, given.piece(argument)));
            value.max(drawn.low).min(drawn.high)
        };
        drawn.values = (0..Drawn::POINTS).map(value).collect();
        drawn
    }

    /// Error in the points: too few, or arguments not ascending.
    fn disorder(&self) -> Diagnostic {
        let (name, argument) = (&self.name.text, &self.argument.text);
        if self.points.len() < 2 {
            let message = words!("the table `{name}` has fewer than two points");
            let hint = words!("what is the same everywhere is a definition: `{name} = ...`");
            return Diagnostic::error("table-points", message, self.name.span).with_hint(hint);
        }
        if let Some(pair) =
            self.points.windows(2).find(|pair| pair[0].x.partial_cmp(&pair[1].x) != Some(Ordering::Less))
        {
            let twice = pair[0].x == pair[1].x;
            let message = if twice {
                words!("two points of the table `{name}` have the same {argument}")
            } else {
                words!("in the table `{name}`, {argument} must increase from point to point")
            };
            let hint = if twice {
                words("for a jump write `steps table`, or move one of the points a little")
            } else {
                words("put the points into order")
            };
            return Diagnostic::error("table-order", message, pair[1].span)
                .with_label(pair[0].span, words("the point before"))
                .with_hint(hint);
        }
        let message = words!("a number of the table `{name}` is too large");
        Diagnostic::error("number-too-large", message, self.name.span)
    }
}

/// The error of a table with too many points.
pub(crate) fn too_many_points(span: Span) -> Diagnostic {
    let message = words!("a table has at most {} points", limits::TABLE_POINTS);
    Diagnostic::error("model-too-large", message, span)
}
