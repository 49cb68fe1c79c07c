//! Aggregates of the run so far: `maximum(y)`, `minimum(y)`, `mean(y)` and `integral(y)`.
//!
//! All of them become ordinary statements. An integral is a state whose rate of change is y. A maximum is the greater of a
//! stored value and the present value. The stored value starts as the initial value. It is updated at every event and where
//! y' passes through zero, which is an event of its own. The function names are not reserved: they are functions only
//! directly before a parenthesis, and only if the author does not define a function of that name.

use crate::notation::quote;
use crate::syntax::{expressions_mut, rewrite};
use crate::{Action, BinaryOperator, EventExtras, Expression, ExpressionKind, Name, Span, Statement, StatementKind};
use program::State;
use std::borrow::Cow;
use std::collections::HashSet;

/// Each function with the function that combines past and present, and the sign of the slope after an extremum.
const EXTREMA: [(&str, &str, BinaryOperator); 2] =
    [("maximum", "max", BinaryOperator::Less), ("minimum", "min", BinaryOperator::Greater)];
const INTEGRAL: &str = "integral";
const MEAN: &str = "mean";

/// Replaces all aggregates of the run so far by ordinary statements.
pub(crate) fn write_out<'a>(statements: Cow<'a, [Statement]>) -> Cow<'a, [Statement]> {
    let named = |statement: &Statement| match &statement.kind {
        StatementKind::Function(function) => Some(function.name.text.clone()),
        StatementKind::Independent { name, .. } => Some(format!(" {}", name.text)),
        _ => None,
    };
    let names: HashSet<String> = statements.iter().filter_map(named).collect();
    let independent = names.iter().find_map(|name| name.strip_prefix(' ')).unwrap_or("t").to_owned();
    let mut writer = Writer { names, independent, added: Vec::new(), kept: Vec::new() };
    let mut written = statements.to_vec();
    written.iter_mut().for_each(|statement| writer.statement(statement));
    if writer.added.is_empty() {
        return statements;
    }
    // Generated statements may contain such functions, too.
    let mut next = 0;
    while let Some(mut statement) = writer.added.get(next).cloned() {
        writer.statement(&mut statement);
        writer.added[next] = statement;
        next += 1;
    }
    for statement in &mut written {
        if let StatementKind::Event { actions, .. } = &mut statement.kind {
            actions.extend(writer.kept.iter().cloned());
        }
    }
    written.append(&mut writer.added);
    Cow::Owned(written)
}

/// Collects the generated statements.
#[derive(Debug)]
struct Writer {
    /// User-defined functions and the calls already replaced.
    names: HashSet<String>,
    independent: String,
    added: Vec<Statement>,
    /// Updates of stored extrema, added to every event.
    kept: Vec<Action>,
}

impl Writer {
    fn statement(&mut self, statement: &mut Statement) {
        if !matches!(statement.kind, StatementKind::Function(_)) {
            for expression in expressions_mut(statement) {
                rewrite(expression, &mut |part| self.call(part));
            }
        }
    }

    /// Replaces a call by a name.
    fn call(&mut self, part: &mut Expression) {
        let ExpressionKind::Call { function, arguments } = &part.kind else { return };
        let [argument] = arguments.as_slice() else { return };
        let called = function.text.as_str();
        let extremum = EXTREMA.into_iter().find(|(name, ..)| *name == called);
        if extremum.is_none() && called != INTEGRAL && called != MEAN || self.names.contains(called) {
            return;
        }
        let name = match quote(argument) {
            short if !short.ends_with("...") => format!("{called}({short})"),
            long => format!("{called}({long}) {}", part.span.start),
        };
        let (argument, whole, is_mean) = (argument.clone(), part.span, called == MEAN);
        *part = Expression::named(&name, whole);
        if !self.names.insert(name.clone()) {
            return;
        }
        match extremum {
            Some((_, keeps, turned)) => self.extremum(&name, keeps, turned, argument, whole),
            None if is_mean => self.mean(&name, argument, whole),
            None => self.integral(&name, argument, whole),
        }
    }

    fn extremum(&mut self, name: &str, keeps: &str, turned: BinaryOperator, argument: Expression, span: Span) {
        let (present, past) = (format!("{name} now"), format!("{name}{}", State::SO_FAR));
        let extreme = || {
            let arguments = [&past, &present].map(|name| Expression::named(name, span)).to_vec();
            Expression::call(keeps, arguments, span)
        };
        self.define(&present, argument, span);
        self.define(name, extreme(), span);
        let value = Expression { kind: ExpressionKind::InitialValue { name: present.clone(), order: 0 }, span };
        let state = Name { text: past.clone(), span };
        self.add(StatementKind::discrete(state.clone(), value, None), span);
        let slope = Expression::derivative(&present, 1, span);
        let condition = Expression::binary(turned, slope, Expression::number(0.0, span), span);
        let action = Action::of(state, 0, extreme());
        let (actions, extras) = (vec![action.clone()], EventExtras::default());
        self.kept.push(action);
        self.add(StatementKind::Event { condition, actions, extras }, span);
    }

    fn integral(&mut self, name: &str, argument: Expression, span: Span) {
        let state = format!("{name}{}", State::SO_FAR);
        self.define(name, Expression::named(&state, span), span);
        let left = Expression::derivative(&state, 1, span);
        self.add(StatementKind::Equation { left, right: argument }, span);
        let (name, value) = (Name { text: state, span }, Expression::number(0.0, span));
        self.add(StatementKind::InitialValue { name, order: 0, value, unit: None }, span);
    }

    /// The integral divided by the time; at the start the value itself.
    fn mean(&mut self, name: &str, argument: Expression, span: Span) {
        let integral = Expression::call(INTEGRAL, vec![argument.clone()], span);
        let time = || Expression::named(&self.independent, span);
        let quotient = Expression::binary(BinaryOperator::Divide, integral, time(), span);
        let begun = Expression::binary(BinaryOperator::Greater, time(), Expression::number(0.0, span), span);
        self.define(name, Expression::conditional(begun, quotient, argument, span), span);
    }

    fn define(&mut self, name: &str, value: Expression, span: Span) {
        let name = Name { text: name.to_owned(), span };
        self.add(StatementKind::Definition { name, value, unit: None }, span);
    }

    fn add(&mut self, kind: StatementKind, span: Span) {
        self.added.push(Statement::of(kind, span));
    }
}
