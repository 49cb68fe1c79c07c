//! Random draws: `x = x + normal(0, 1 [m])` in an event, `v(0) = normal(0, s)` at the start.
//!
//! Every draw gets a random stream of its own. The stream is a definition that mixes the seed, the name of the target
//! quantity, the number of the draw among those of this target in text order, and the number of firings of the event. So a
//! draw does not depend on earlier draws: stepping back in the run, another step size or another event does not change it.

use crate::names::for_each;
use crate::syntax::expressions;
use crate::{
    Action, BinaryOperator, Diagnostic, EventExtras, Expression, ExpressionKind, Name, ParameterForm, Span, Statement,
    StatementKind,
};
use program::State;
use program::functions::Function;
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use units::{fnv, words};

/// Name of the function that returns one of its arguments at random.
const PICK: &str = "pick";

/// Prefix of the names of streams. It contains a space, so it cannot occur in source text.
const STREAM: &str = "draw ";

/// True if the first of `arguments` is the stream of a draw.
pub(crate) fn has_stream(arguments: &[Expression]) -> bool {
    let name = arguments.first().map(|first| &first.kind);
    matches!(name, Some(ExpressionKind::Name { name, .. }) if name.starts_with(STREAM))
}

/// True if `name` is a function that draws at random.
pub(crate) fn draws(name: &str) -> bool {
    name == PICK || Function::named(name).is_some_and(Function::draws)
}

/// Error for a draw in a place where draws are not allowed.
pub(crate) fn out_of_place(name: &Name) -> Diagnostic {
    let message = words!("`{}` draws at random, and here the value would be another one at each look", name.text);
    Diagnostic::error("draw-out-of-place", message, name.span).with_hint(words(
        "draw in the action of an event, in `every`, in `next` or in a value at the start: `discrete x = 0` and `every 1 [s] { x = normal(0, 1) }`",
    ))
}

/// Adds a stream to every draw that stands in an allowed place.
pub(crate) fn write_out<'a>(
    statements: Cow<'a, [Statement]>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    let seeds: Vec<&Name> = statements.iter().filter_map(seed).collect();
    if let [first, second, ..] = seeds.as_slice() {
        let message = words("there is more than one seed");
        diagnostics.push(
            Diagnostic::error("duplicate-seed", message, second.span)
                .with_label(first.span, words("the first is here"))
                .with_hint(words("one decides all draws; leave this out")),
        );
    }
    if !statements.iter().any(has_draw) {
        return statements;
    }
    let own = |statement: &Statement| match &statement.kind {
        StatementKind::Function(function) => Some(function.name.text.clone()),
        _ => None,
    };
    let mut writer = Writer {
        seed: seeds.first().map(|name| name.text.clone()),
        functions: statements.iter().filter_map(own).collect(),
        drawn: HashMap::new(),
        added: Vec::new(),
        first: None,
        diagnostics: Vec::new(),
    };
    let mut written = statements.to_vec();
    written.iter_mut().enumerate().for_each(|(number, statement)| writer.statement(number, statement));
    let Writer { seed, mut added, first, diagnostics: mut found, .. } = writer;
    diagnostics.append(&mut found);
    if let (None, Some(first)) = (seed, &first) {
        let message = words("nothing gives the seed of the random draws");
        diagnostics.push(
            Diagnostic::error("draw-without-seed", message, *first)
                .with_hint(words("add the statement: random seed = 1 in 1..9999 \"Seed\"")),
        );
    }
    if first.is_none() {
        return statements;
    }
    written.append(&mut added);
    Cow::Owned(written)
}

fn has_draw(statement: &Statement) -> bool {
    let mut found = false;
    for expression in expressions(statement) {
        for_each(expression, |part| {
            found |= matches!(&part.kind, ExpressionKind::Call { function, .. } if draws(&function.text));
        });
    }
    found
}

fn seed(statement: &Statement) -> Option<&Name> {
    match &statement.kind {
        StatementKind::Parameter(parameter) if parameter.form == ParameterForm::Seed => Some(&parameter.name),
        _ => None,
    }
}

/// Adds streams to draws.
#[derive(Debug)]
struct Writer {
    seed: Option<String>,
    /// User-defined functions; they may have the names of drawing functions.
    functions: HashSet<String>,
    /// Number of draws per target quantity.
    drawn: HashMap<String, u32>,
    added: Vec<Statement>,
    /// Place of the first draw.
    first: Option<Span>,
    diagnostics: Vec<Diagnostic>,
}

impl Writer {
    fn statement(&mut self, number: usize, statement: &mut Statement) {
        match &mut statement.kind {
            StatementKind::InitialValue { name, order, value, .. } => {
                self.value(&format!("{}{}(0)", name.text, "'".repeat(*order as usize)), None, value);
            }
            StatementKind::Discrete { name, value, .. } => self.value(&format!("{}(0)", name.text), None, value),
            StatementKind::Event { actions, extras: EventExtras { names, .. }, .. } => {
                let counter = format!("firings {number}{}", State::SO_FAR);
                let before = self.added.len();
                for Action { name, order, value, .. } in names.iter_mut().chain(actions.iter_mut()) {
                    self.value(&format!("{}{}", name.text, "'".repeat(*order as usize)), Some(&counter), value);
                }
                if self.added.len() > before {
                    let span = statement.span;
                    let name = Name { text: counter.clone(), span };
                    let one = Expression::binary(
                        BinaryOperator::Add,
                        Expression::named(&counter, span),
                        Expression::number(1.0, span),
                        span,
                    );
                    actions.push(Action::of(name.clone(), 0, one));
                    self.added
                        .push(Statement::of(StatementKind::discrete(name, Expression::number(0.0, span), None), span));
                }
            }
            _ => {}
        }
    }

    /// Adds streams to the draws of a value. `counter` is the quantity that counts the firings of the event, `None` for a
    /// value at the start.
    fn value(&mut self, target: &str, counter: Option<&str>, value: &mut Expression) {
        // From left to right, the order of the text.
        let mut waiting = vec![value];
        while let Some(next) = waiting.pop() {
            let span = next.span;
            if let ExpressionKind::Call { function, arguments } = &mut next.kind
                && draws(&function.text)
                && !self.functions.contains(&function.text)
                && !has_stream(arguments)
            {
                self.first = self.first.or(Some(span));
                if self.counts(function, arguments.len()) {
                    let stream = self.stream(target, counter, span);
                    if function.text == PICK {
                        next.kind = picked(std::mem::take(arguments), &stream, span).kind;
                    } else {
                        arguments.insert(0, stream);
                    }
                } else {
                    next.kind = ExpressionKind::Error;
                }
            }
            let mut operands = next.operands_mut();
            operands.reverse();
            waiting.extend(operands);
        }
    }

    /// True if a draw has the right number of arguments; reports an error if not.
    fn counts(&mut self, function: &Name, given: usize) -> bool {
        let (takes, form) = match function.text.as_str() {
            PICK => (given.max(1), "pick(a, b, c)"),
            "uniform" => (2, "uniform(low, high)"),
            "normal" => (2, "normal(mean, deviation)"),
            "binomial" => (2, "binomial(trials, probability)"),
            "poisson" => (1, "poisson(mean)"),
            _ => (1, "exponential(mean)"),
        };
        if takes != given {
            let message = words!("the form is {form}; {given} is not the number of its arguments");
            self.diagnostics.push(Diagnostic::error("wrong-argument-count", message, function.span));
        }
        takes == given
    }

    /// Adds a definition for the stream of the next draw for `target` and returns its name as an expression.
    fn stream(&mut self, target: &str, counter: Option<&str>, span: Span) -> Expression {
        let number = self.drawn.entry(target.to_owned()).or_default();
        *number += 1;
        let site = site(&format!("{target} {number}"));
        let seed =
            self.seed.as_deref().map_or_else(|| Expression::number(0.0, span), |seed| Expression::named(seed, span));
        let mixed = |a, b| Expression::call(Function::STREAM, vec![a, b], span);
        let firing = counter.map_or_else(|| Expression::number(0.0, span), |counter| Expression::named(counter, span));
        let value = mixed(mixed(seed, Expression::number(site, span)), firing);
        let name = format!("{STREAM}{number} for {target}");
        let definition = StatementKind::Definition { name: Name { text: name.clone(), span }, value, unit: None };
        self.added.push(Statement::of(definition, span));
        Expression::named(&name, span)
    }
}

/// Stable integer hash of a text: 64-bit FNV-1a, of which the highest 53 bits are kept to fit an `f64`.
fn site(text: &str) -> f64 {
    (fnv::hashed(fnv::START, text.bytes()) >> 11) as f64
}

/// `if u < 1/3 then a else if u < 2/3 then b else c`, where u is uniform between 0 and 1.
fn picked(values: Vec<Expression>, stream: &Expression, span: Span) -> Expression {
    let count = values.len() as f64;
    let part = || {
        let arguments = vec![stream.clone(), Expression::number(0.0, span), Expression::number(1.0, span)];
        Expression::call("uniform", arguments, span)
    };
    let mut values: Vec<(usize, Expression)> = values.into_iter().enumerate().collect();
    let Some((_, last)) = values.pop() else { return Expression::nothing(span) };
    values.into_iter().rev().fold(last, |other, (number, value)| {
        let limit = Expression::number((number as f64 + 1.0) / count, span);
        let condition = Expression::binary(BinaryOperator::Less, part(), limit, span);
        Expression::conditional(condition, value, other, span)
    })
}
