//! Periodic events: `every 0.1 [s] from 0 [s] { ... }` fires at from + n interval, with n an integer, but not at the start
//! of the run.
//!
//! Each becomes an event with the condition that the time has passed the next of these moments. A discrete quantity counts
//! the moments. So each moment is a product, not a sum with accumulated rounding, and all of them are scheduled exactly.

use crate::{
    Action, BinaryOperator, Diagnostic, Expression, ExpressionKind, Name, Span, Statement, StatementKind, UnaryOperator,
};
use program::State;
use std::borrow::Cow;
use units::words;

/// Replaces all periodic events by events with conditions.
pub(crate) fn write_out<'a>(
    statements: Cow<'a, [Statement]>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    let is_tick = |statement: &Statement| matches!(&statement.kind, StatementKind::Event { extras, .. } if extras.every.is_some());
    if !statements.iter().any(is_tick) {
        return statements;
    }
    let independent = crate::syntax::independent(&statements);
    let counts = crate::maps::counts(&statements);
    let mut written = statements.to_vec();
    let mut added = Vec::new();
    for (number, statement) in written.iter_mut().enumerate() {
        if let StatementKind::Event { condition, actions, extras } = &mut statement.kind
            && let Some(every) = extras.every.take()
        {
            let (interval, from) = *every;
            if is_nothing(&interval) {
                let message = words("an event cannot happen at intervals of 0");
                diagnostics.push(
                    Diagnostic::error("interval-of-zero", message, interval.span)
                        .with_hint(words("write an interval above 0, such as `every 0.1 [s]`")),
                );
            }
            diagnostics.extend(ends_at_zero(&statements, &interval));
            let ticks = Ticks {
                independent: &independent,
                counts,
                next: format!("every {number}{}", State::SO_FAR),
                span: interval.span,
            };
            added.push(ticks.count(&interval, from.as_ref()));
            actions.push(ticks.counted());
            *condition = ticks.passed(interval, from);
        }
    }
    written.append(&mut added);
    Cow::Owned(written)
}

/// True if an interval is the number 0 or subnormal in SI units.
fn is_nothing(interval: &Expression) -> bool {
    match &interval.kind {
        ExpressionKind::Number { value, unit } => !unit.as_ref().map_or(*value, |unit| unit.to_si(*value)).is_normal(),
        _ => false,
    }
}

/// Warning for an interval that is a parameter whose range reaches 0: there the event no longer fires.
fn ends_at_zero(statements: &[Statement], interval: &Expression) -> Option<Diagnostic> {
    let ExpressionKind::Name { name, order: 0 } = &interval.kind else { return None };
    let parameter = statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Parameter(parameter) if parameter.name.text == *name => Some(parameter),
        _ => None,
    })?;
    let is_above = |value: f64| value > 0.0;
    if is_above(parameter.value) && parameter.range.as_ref().is_none_or(|range| is_above(range.low)) {
        return None;
    }
    let message = words!("`{name}` can be 0, and at intervals of 0 an event does not happen");
    let hint = words!("let the range of `{name}` begin above 0");
    Some(Diagnostic::warning("interval-of-zero", message, interval.span).with_hint(hint))
}

/// The moments of one periodic event.
struct Ticks<'a> {
    independent: &'a str,
    /// True if the independent variable is discrete: the moments are then counts.
    counts: bool,
    /// Name of the quantity that holds the number of the next moment.
    next: String,
    span: Span,
}

impl Ticks<'_> {
    /// The counting discrete quantity. Its initial value is the least number whose moment lies after the start.
    fn count(&self, interval: &Expression, from: Option<&Expression>) -> Statement {
        let span = self.span;
        let number = |value| Expression::number(value, span);
        let first = match from {
            None => number(1.0),
            Some(from) => {
                let later = Expression::binary(BinaryOperator::Greater, from.clone(), number(0.0), span);
                let before = Expression::unary(UnaryOperator::Negate, from.clone(), span);
                let passed = Expression::binary(BinaryOperator::Divide, before, interval.clone(), span);
                let whole = Expression::call("floor", vec![passed], span);
                let next = Expression::binary(BinaryOperator::Add, whole, number(1.0), span);
                Expression::conditional(later, number(0.0), next, span)
            }
        };
        let name = Name { text: self.next.clone(), span };
        Statement::of(StatementKind::discrete(name, first, None), span)
    }

    /// The number of the next moment.
    fn number(&self) -> Expression {
        Expression::named(&self.next, self.span)
    }

    /// The action n = n + 1.
    fn counted(&self) -> Action {
        let name = Name { text: self.next.clone(), span: self.span };
        let one = Expression::number(1.0, self.span);
        let value = Expression::binary(BinaryOperator::Add, self.number(), one, self.span);
        Action::of(name, 0, value)
    }

    /// The condition t > from + n interval, or t >= from + n interval for a discrete t.
    fn passed(&self, interval: Expression, from: Option<Expression>) -> Expression {
        let since = Expression::binary(BinaryOperator::Multiply, self.number(), interval, self.span);
        let moment = match from {
            Some(from) => Expression::binary(BinaryOperator::Add, from, since, self.span),
            None => since,
        };
        let passed = if self.counts { BinaryOperator::GreaterOrEqual } else { BinaryOperator::Greater };
        Expression::binary(passed, Expression::named(self.independent, self.span), moment, self.span)
    }
}
