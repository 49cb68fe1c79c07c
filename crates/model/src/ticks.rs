//! Events at equal intervals: `every 0.1 [s] from 0 [s] { ... }` fires at from + n interval, n a whole number, but not at the
//! start of the run.
//!
//! It is written out as an event whose condition is that the time has passed the next of these moments. Which one that is, is
//! counted by a discrete quantity, so that the moments are products and no sums, and all of them are scheduled exactly.

use crate::{Action, BinaryOperator, Expression, ExpressionKind, Name, Span, Statement, StatementKind, UnaryOperator};
use std::borrow::Cow;

/// The statements with all events at equal intervals as events with conditions.
pub(crate) fn write_out(statements: &[Statement]) -> Cow<'_, [Statement]> {
    let is_tick = |statement: &Statement| matches!(&statement.kind, StatementKind::Event { extras, .. } if extras.every.is_some());
    if !statements.iter().any(is_tick) {
        return Cow::Borrowed(statements);
    }
    let independent = crate::moments::independent(statements);
    let counts = crate::maps::counts(statements);
    let mut written = statements.to_vec();
    let mut added = Vec::new();
    for (number, statement) in written.iter_mut().enumerate() {
        if let StatementKind::Event { condition, actions, extras } = &mut statement.kind
            && let Some(every) = extras.every.take()
        {
            let (interval, from) = *every;
            let ticks = Ticks {
                independent: &independent,
                counts,
                next: format!("every {number} so far"),
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

/// The moments of one event.
struct Ticks<'a> {
    independent: &'a str,
    /// Whether it counts: the moments then are counts, and nothing comes between.
    counts: bool,
    /// The number of the next one.
    next: String,
    span: Span,
}

impl Ticks<'_> {
    fn of(&self, kind: ExpressionKind) -> Expression {
        Expression { kind, span: self.span }
    }

    fn name(&self, name: &str, order: u32) -> Expression {
        self.of(ExpressionKind::Name { name: name.to_owned(), order })
    }

    fn number(&self, value: f64) -> Expression {
        self.of(ExpressionKind::Number { value, unit: None })
    }

    fn binary(&self, operator: BinaryOperator, left: Expression, right: Expression) -> Expression {
        self.of(ExpressionKind::Binary(operator, Box::new(left), Box::new(right)))
    }

    /// The discrete quantity that counts: at the start the least number whose moment lies behind it.
    fn count(&self, interval: &Expression, from: Option<&Expression>) -> Statement {
        let first = match from {
            None => self.number(1.0),
            Some(from) => {
                let later = self.binary(BinaryOperator::Greater, from.clone(), self.number(0.0));
                let before = self.of(ExpressionKind::Unary(UnaryOperator::Negate, Box::new(from.clone())));
                let passed = self.binary(BinaryOperator::Divide, before, interval.clone());
                let function = Name { text: "floor".to_owned(), span: self.span };
                let whole = self.of(ExpressionKind::Call { function, arguments: vec![passed] });
                let next = self.binary(BinaryOperator::Add, whole, self.number(1.0));
                self.of(ExpressionKind::If(Box::new(later), Box::new(self.number(0.0)), Box::new(next)))
            }
        };
        let rate = Box::new([self.name(&self.next, 1), self.number(0.0)]);
        let name = Name { text: self.next.clone(), span: self.span };
        let kind = StatementKind::Discrete { name, value: first, unit: None, rate };
        Statement::of(kind, self.span)
    }

    /// n = n + 1
    fn counted(&self) -> Action {
        let name = Name { text: self.next.clone(), span: self.span };
        let value = self.binary(BinaryOperator::Add, self.name(&self.next, 0), self.number(1.0));
        Action::of(name, 0, value)
    }

    /// t > from + n interval; t >= from + n interval where t counts
    fn passed(&self, interval: Expression, from: Option<Expression>) -> Expression {
        let since = self.binary(BinaryOperator::Multiply, self.name(&self.next, 0), interval);
        let moment = match from {
            Some(from) => self.binary(BinaryOperator::Add, from, since),
            None => since,
        };
        let passed = if self.counts { BinaryOperator::GreaterOrEqual } else { BinaryOperator::Greater };
        self.binary(passed, self.name(self.independent, 0), moment)
    }
}
