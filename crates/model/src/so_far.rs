//! What a run has been so far: `maximum(y)`, `minimum(y)`, `mean(y)` and `integral(y)`.
//!
//! All of it is written out in statements that there are already. An integral is a state whose rate of change is y. A maximum
//! is what is kept of the past or the present value, whichever is greater; kept is the value at the start, at every event, and
//! where y' passes through zero, which is an event that is found between the steps. The words are free as names: only directly
//! before a parenthesis they are functions, and not if the author has one of that name.

use crate::moments::{expressions_mut, rewrite};
use crate::notation::quote;
use crate::{Action, BinaryOperator, EventExtras, Expression, ExpressionKind, Name, Span, Statement, StatementKind};
use std::borrow::Cow;
use std::collections::HashSet;

/// The functions, each with the function that keeps the past and the sign of the slope behind an extremum.
const EXTREMA: [(&str, &str, BinaryOperator); 2] =
    [("maximum", "max", BinaryOperator::Less), ("minimum", "min", BinaryOperator::Greater)];
const INTEGRAL: &str = "integral";
const MEAN: &str = "mean";

/// The statements with all that has been so far as statements of their own.
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
    // What is added may hold such functions itself.
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

/// Writes statements that the author did not have to.
#[derive(Debug)]
struct Writer {
    /// The author's functions, and what has been written out.
    names: HashSet<String>,
    independent: String,
    added: Vec<Statement>,
    /// What every event keeps.
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

    /// Puts a name in the place of a call.
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
        part.kind = ExpressionKind::Name { name: name.clone(), order: 0 };
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
        let (present, past) = (format!("{name} now"), format!("{name} so far"));
        let of = |kind| Expression { kind, span };
        let extreme = || {
            let arguments = [&past, &present].map(|name| of(named_kind(name))).to_vec();
            of(ExpressionKind::Call { function: Name { text: keeps.to_owned(), span }, arguments })
        };
        self.define(&present, argument, span);
        self.define(name, extreme(), span);
        let rate = [of(ExpressionKind::Name { name: past.clone(), order: 1 }), of(number(0.0))];
        let value = of(ExpressionKind::InitialValue { name: present.clone(), order: 0 });
        let state = Name { text: past.clone(), span };
        self.add(StatementKind::Discrete { name: state.clone(), value, unit: None, rate: Box::new(rate) }, span);
        let slope = of(ExpressionKind::Name { name: present.clone(), order: 1 });
        let condition = of(ExpressionKind::Binary(turned, Box::new(slope), Box::new(of(number(0.0)))));
        let action = Action::of(state, 0, extreme());
        let (actions, extras) = (vec![action.clone()], EventExtras::default());
        self.kept.push(action);
        self.add(StatementKind::Event { condition, actions, extras }, span);
    }

    fn integral(&mut self, name: &str, argument: Expression, span: Span) {
        let state = format!("{name} so far");
        let of = |kind| Expression { kind, span };
        self.define(name, of(named_kind(&state)), span);
        let left = of(ExpressionKind::Name { name: state.clone(), order: 1 });
        self.add(StatementKind::Equation { left, right: argument }, span);
        let value = of(number(0.0));
        let name = Name { text: state, span };
        self.add(StatementKind::InitialValue { name, order: 0, value, unit: None }, span);
    }

    /// The integral by the time; at the start the value itself.
    fn mean(&mut self, name: &str, argument: Expression, span: Span) {
        let of = |kind| Box::new(Expression { kind, span });
        let function = Name { text: INTEGRAL.to_owned(), span };
        let integral = of(ExpressionKind::Call { function, arguments: vec![argument.clone()] });
        let time = || of(named_kind(&self.independent));
        let quotient = of(ExpressionKind::Binary(BinaryOperator::Divide, integral, time()));
        let begun = of(ExpressionKind::Binary(BinaryOperator::Greater, time(), of(number(0.0))));
        let value = Expression { kind: ExpressionKind::If(begun, quotient, Box::new(argument)), span };
        self.define(name, value, span);
    }

    fn define(&mut self, name: &str, value: Expression, span: Span) {
        let name = Name { text: name.to_owned(), span };
        self.add(StatementKind::Definition { name, value, unit: None }, span);
    }

    fn add(&mut self, kind: StatementKind, span: Span) {
        self.added.push(Statement::of(kind, span));
    }
}

fn named_kind(name: &str) -> ExpressionKind {
    ExpressionKind::Name { name: name.to_owned(), order: 0 }
}

fn number(value: f64) -> ExpressionKind {
    ExpressionKind::Number { value, unit: None }
}
