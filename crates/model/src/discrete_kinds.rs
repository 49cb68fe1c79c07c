//! Discrete quantities whose values are texts or truth values: `discrete phase = "up"`, `discrete moving = true`.
//!
//! States are numbers. So each such quantity becomes a state that holds 1 or 0 or the index of the text, and a definition
//! with the author's name that turns the number into the value. The name of the state cannot occur in source text. Events
//! set the state.

use crate::{
    BinaryOperator, Diagnostic, Expression, ExpressionKind, Name, Span, Statement, StatementKind, UnaryOperator, limits,
};
use program::State;
use std::borrow::Cow;
use std::collections::HashMap;
use units::words;

/// Kind of values of a discrete quantity that is not a number.
enum Values {
    /// True or false.
    Truth,
    /// One of these texts.
    Texts(Vec<String>),
}

/// Replaces all such quantities by numeric states and definitions.
pub(crate) fn write_out<'a>(
    statements: Cow<'a, [Statement]>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    let mut kinds: HashMap<String, Values> = statements.iter().filter_map(kind).collect();
    if kinds.is_empty() {
        return statements;
    }
    let mut written = Vec::with_capacity(statements.len() + kinds.len());
    for statement in statements.iter() {
        let mut statement = statement.clone();
        match &mut statement.kind {
            StatementKind::Discrete { name, value, .. } => {
                if let Some(values) = kinds.get_mut(&name.text) {
                    let value = number(value, values, name, diagnostics);
                    let state =
                        StatementKind::discrete(Name { text: state_name(&name.text), span: name.span }, value, None);
                    written.push(Statement::of(state, statement.span));
                    continue;
                }
            }
            StatementKind::Event { actions, .. } => {
                for action in actions {
                    if let Some(values) = kinds.get_mut(&action.name.text)
                        && action.order == 0
                    {
                        action.value = number(&action.value, values, &action.name, diagnostics);
                        action.name.text = state_name(&action.name.text);
                    }
                }
            }
            _ => {}
        }
        written.push(statement);
    }
    // The list of texts is complete only after all events.
    for statement in statements.iter() {
        if let StatementKind::Discrete { name, unit, .. } = &statement.kind
            && let Some(values) = kinds.get(&name.text)
        {
            let value = meaning(&name.text, values, name.span);
            let kind = StatementKind::Definition { name: name.clone(), value, unit: unit.clone() };
            written.push(Statement { kind, ..statement.clone() });
        }
    }
    Cow::Owned(written)
}

/// Name of the state behind a quantity.
fn state_name(name: &str) -> String {
    format!("{name}{}", State::SO_FAR)
}

/// Name of the truth or text quantity whose state is `state`, or `None`.
pub(crate) fn quantity(state: &str) -> Option<&str> {
    state.strip_suffix(State::SO_FAR).filter(|name| !name.contains([' ', '(']))
}

fn kind(statement: &Statement) -> Option<(String, Values)> {
    let StatementKind::Discrete { name, value, .. } = &statement.kind else { return None };
    let mut value = value;
    while let ExpressionKind::If(_, chosen, _) = &value.kind {
        value = chosen;
    }
    let values = match &value.kind {
        ExpressionKind::Text(_) => Values::Texts(Vec::new()),
        ExpressionKind::Unary(UnaryOperator::Not, _) => Values::Truth,
        ExpressionKind::Binary(operator, ..) if operator.is_logical() => Values::Truth,
        _ if literal(value).is_some() => Values::Truth,
        _ => return None,
    };
    Some((name.text.clone(), values))
}

/// Value of the literal `true` or `false`, `None` for another expression.
fn literal(value: &Expression) -> Option<bool> {
    match &value.kind {
        ExpressionKind::Name { name, order: 0 } if name == "true" => Some(true),
        ExpressionKind::Name { name, order: 0 } if name == "false" => Some(false),
        _ => None,
    }
}

/// The number that encodes a value of the quantity `name`.
fn number(value: &Expression, values: &mut Values, name: &Name, diagnostics: &mut Vec<Diagnostic>) -> Expression {
    let span = value.span;
    if let ExpressionKind::If(condition, chosen, other) = &value.kind {
        let [chosen, other] = [chosen, other].map(|branch| number(branch, values, name, diagnostics));
        return Expression::conditional((**condition).clone(), chosen, other, span);
    }
    match values {
        Values::Truth => match literal(value) {
            Some(truth) => Expression::number(f64::from(u8::from(truth)), span),
            None if matches!(value.kind, ExpressionKind::Number { .. } | ExpressionKind::Text(_)) => {
                diagnostics.push(no_truth(name, span));
                Expression::nothing(span)
            }
            None => {
                let [one, zero] = [1.0, 0.0].map(|number| Expression::number(number, span));
                Expression::conditional(value.clone(), one, zero, span)
            }
        },
        Values::Texts(texts) => {
            let ExpressionKind::Text(text) = &value.kind else {
                diagnostics.push(no_text(name, span));
                return Expression::nothing(span);
            };
            let place = texts.iter().position(|known| known == text).unwrap_or(texts.len());
            if place == limits::ALTERNATIVES {
                diagnostics.push(too_many_texts(name, span));
                return Expression::nothing(span);
            }
            if place == texts.len() {
                texts.push(text.clone());
            }
            Expression::number(place as f64, span)
        }
    }
}

fn no_truth(name: &Name, span: Span) -> Diagnostic {
    let message = words!("`{}` is true or false, and this is neither", name.text);
    Diagnostic::error("discrete-truth", message, span)
        .with_hint(words!("such as: {0} = true, or {0} = y > 0 [m]", name.text))
}

fn no_text(name: &Name, span: Span) -> Diagnostic {
    let message = words!("`{}` is a text, and this is none in quotation marks", name.text);
    Diagnostic::error("discrete-text", message, span)
        .with_hint(words!("such as: {0} = \"up\", or {0} = if y > 0 [m] then \"up\" else \"down\"", name.text))
}

fn too_many_texts(name: &Name, span: Span) -> Diagnostic {
    let message = words!("`{}` has more than {} texts", name.text, limits::ALTERNATIVES);
    Diagnostic::error("model-too-large", message, span)
}

/// Expression that decodes the number behind the quantity `name`.
fn meaning(name: &str, values: &Values, span: Span) -> Expression {
    let is = |number: f64| {
        let state = Expression::named(&state_name(name), span);
        Expression::binary(BinaryOperator::Equal, state, Expression::number(number, span), span)
    };
    match values {
        Values::Truth => is(1.0),
        Values::Texts(texts) => {
            let text = |text: &String| Expression { kind: ExpressionKind::Text(text.clone()), span };
            let mut all = texts.iter().enumerate().rev();
            let last = all.next().map_or_else(|| Expression::nothing(span), |(_, last)| text(last));
            all.fold(last, |other, (number, own)| Expression::conditional(is(number as f64), text(own), other, span))
        }
    }
}
