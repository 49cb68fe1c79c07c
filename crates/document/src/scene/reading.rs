//! Numbers in scenes: components of points, ends of ranges.

use crate::expressions::{Expressions, Placed};
use model::{BinaryOperator, Expression, ExpressionKind};
use std::ops::Range;

impl Expressions<'_> {
    /// Number and unit as written, without conversion; `None` for another expression.
    pub fn written(&self, range: Range<usize>) -> Option<(f64, String)> {
        let (expression, _, _) = model::parse_expression(self.source, range);
        match expression.kind {
            ExpressionKind::Number { value, unit } => Some((value, unit.map(|unit| unit.text).unwrap_or_default())),
            _ => None,
        }
    }

    /// Expression for the point at the fraction `part` between two ends: `low` for 0, `high` for 1.
    pub fn part_of(&mut self, low: Range<usize>, high: Range<usize>, part: f64) -> Option<Expression> {
        let (low, _, found) = model::parse_expression(self.source, low);
        let (high, _, further) = model::parse_expression(self.source, high);
        if model::has_errors(&found) || model::has_errors(&further) {
            return None;
        }
        let span = high.span;
        let boxed = |kind| Box::new(Expression { kind, span });
        let weight = |value: f64| boxed(ExpressionKind::Number { value, unit: None });
        let weighted =
            |value: f64, end| boxed(ExpressionKind::Binary(BinaryOperator::Multiply, weight(value), Box::new(end)));
        let kind = ExpressionKind::Binary(BinaryOperator::Add, weighted(1.0 - part, low), weighted(part, high));
        Some(Expression { kind, span })
    }

    /// Compiles one component of a point: the expression in `range` with the byte ranges `without` blanked.
    pub fn component(&mut self, range: Range<usize>, without: &[Range<usize>]) -> Option<Placed> {
        let source = self.source;
        let covered = self.covered.get_or_insert_with(|| source.to_owned());
        for part in without {
            covered.replace_range(part.clone(), &" ".repeat(part.len()));
        }
        let (expression, unit, diagnostics) = model::parse_expression(covered, range.clone());
        covered.replace_range(range.clone(), &source[range]);
        let failed = model::has_errors(&diagnostics);
        self.diagnostics.extend(diagnostics);
        let placed = if failed { None } else { self.place(expression, unit.as_ref()) }?;
        self.expect_number(placed)
    }

    /// First two components of the vector in `range`. `None` if the text cannot be parsed, `Some(None)` after an error in
    /// the vector.
    pub fn vector(&mut self, range: Range<usize>) -> Option<Option<(Placed, Placed)>> {
        let (expression, _, diagnostics) = model::parse_expression(self.source, range);
        if model::has_errors(&diagnostics) {
            return None;
        }
        let Some(components) = self.components(expression) else { return Some(None) };
        let mut components = components.into_iter();
        Some(Some((components.next()?, components.next()?)))
    }

    /// Both ends of `LOW..HIGH`. A unit after `HIGH` also applies to a bare number before it.
    pub fn interval(&mut self, low: Range<usize>, high: Range<usize>) -> Option<(Placed, Placed)> {
        let (mut low, low_unit, mut diagnostics) = model::parse_expression(self.source, low);
        let (high, high_unit, further) = model::parse_expression(self.source, high);
        diagnostics.extend(further);
        let failed = model::has_errors(&diagnostics);
        self.diagnostics.extend(diagnostics);
        if failed {
            return None;
        }
        if let (Some(bare), Some(stated)) = (unit_mut(&mut low), unit_of(&high))
            && bare.is_none()
        {
            *bare = Some(stated.clone());
        }
        let low = self.place(low, low_unit.as_ref()).and_then(|low| self.expect_number(low));
        let high = self.place(high, high_unit.as_ref()).and_then(|high| self.expect_number(high));
        low.zip(high)
    }
}

/// Unit of a number, with or without a sign.
fn unit_of(expression: &Expression) -> Option<&units::Unit> {
    match &expression.kind {
        ExpressionKind::Number { unit, .. } => unit.as_ref(),
        ExpressionKind::Unary(_, operand) => unit_of(operand),
        _ => None,
    }
}

/// Mutable unit of a number, with or without a sign.
fn unit_mut(expression: &mut Expression) -> Option<&mut Option<units::Unit>> {
    match &mut expression.kind {
        ExpressionKind::Number { unit, .. } => Some(unit),
        ExpressionKind::Unary(_, operand) => unit_mut(operand),
        _ => None,
    }
}
