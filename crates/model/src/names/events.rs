//! Checks of events: their actions may change only states.

use super::declarations::{Declarations, EventEntry};
use super::scope::Meaning;
use super::traverse::for_each;
use super::unknown::Unknown;
use crate::notation::{primed, quote};
use crate::{Action, BinaryOperator, Diagnostic, Expression, ExpressionKind, UnaryOperator, discrete_kinds};
use units::{Words, words};

/// Checks the condition of an event and the names on the left of its actions.
pub(crate) fn check_event(
    declarations: &Declarations,
    unknowns: &[Unknown],
    event: &EventEntry,
    diagnostics: &mut Vec<Diagnostic>,
) {
    if crossing(declarations, event).is_none() {
        for_each(event.condition, |part| {
            if let ExpressionKind::Binary(BinaryOperator::Equal, left, right) = &part.kind
                && [left, right].into_iter().all(|side| is_number(declarations, side, 0))
            {
                diagnostics.push(at_equality(part, left, right));
            }
        });
    }
    for (index, action) in event.actions.iter().enumerate() {
        if let Some(diagnostic) = check_action(declarations, unknowns, action) {
            diagnostics.push(diagnostic);
        }
        let is_same = |other: &&Action| other.name.text == action.name.text && other.order == action.order;
        if let Some(first) = event.actions[..index].iter().find(is_same) {
            let message = words!(
                "the event changes `{}` twice",
                primed(discrete_kinds::quantity(&action.name.text).unwrap_or(&action.name.text), action.order)
            );
            diagnostics.push(
                Diagnostic::error("duplicate-action", message, action.name.span)
                    .with_label(first.name.span, words("first here"))
                    .with_note(words("all actions of an event use the values before it")),
            );
        }
    }
}

/// Both sides, if the whole condition of an event is an equation `a == b` of numbers. Such an event fires when the sides
/// cross.
pub(crate) fn crossing<'a>(
    declarations: &Declarations,
    event: &EventEntry<'a>,
) -> Option<(&'a Expression, &'a Expression)> {
    match &event.condition.kind {
        ExpressionKind::Binary(BinaryOperator::Equal, left, right)
            if [left, right].into_iter().all(|side| is_number(declarations, side, 0)) =>
        {
            Some((left, right))
        }
        _ => None,
    }
}

/// True if the form of an expression shows that it is a number, not a truth value or a text.
fn is_number(declarations: &Declarations, expression: &Expression, depth: usize) -> bool {
    /// Maximum number of nested definitions that are followed.
    const DEEPEST: usize = 32;
    match &expression.kind {
        ExpressionKind::Text(_) | ExpressionKind::Unary(UnaryOperator::Not, _) => false,
        ExpressionKind::Binary(operator, ..) => !operator.is_logical(),
        ExpressionKind::Expansion(expansion) => depth < DEEPEST && is_number(declarations, &expansion.body, depth + 1),
        ExpressionKind::If(_, chosen, _) => depth < DEEPEST && is_number(declarations, chosen, depth + 1),
        ExpressionKind::Name { name, order: 0 } => match declarations.scope.meaning(name) {
            Some(Meaning::Definition(index)) => {
                depth < DEEPEST && is_number(declarations, declarations.definitions[index].value, depth + 1)
            }
            _ => true,
        },
        _ => true,
    }
}

fn at_equality(part: &Expression, left: &Expression, right: &Expression) -> Diagnostic {
    let message = words("this is hardly ever true exactly, so the event may never fire");
    let (left, right) = (quote(left), quote(right));
    Diagnostic::warning("event-at-equality", message, part.span).with_hint(words!(
        "write `{left} < {right}` or `{left} > {right}`; only alone, as in `when {left} == {right}`, is it a crossing"
    ))
}

fn check_action(declarations: &Declarations, unknowns: &[Unknown], action: &Action) -> Option<Diagnostic> {
    let name = &action.name.text;
    let written = primed(name, action.order);
    let error = |message: Words| Diagnostic::error("event-changes-no-state", message, action.name.span);
    Some(match declarations.scope.meaning(name) {
        Some(Meaning::Variable(index)) => {
            let unknown = &unknowns[index];
            if action.order < unknown.highest {
                return None;
            }
            error(words!("an event cannot change `{written}`: the equations determine it"))
                .with_label(unknown.span, words("it is determined here"))
                .with_hint(words!("change `{}` instead", primed(name, unknown.highest - 1)))
        }
        Some(Meaning::Definition(index)) => {
            let definition = &declarations.definitions[index];
            let diagnostic = error(words!("an event cannot change `{written}`: `{name}` is defined by an expression"))
                .with_label(definition.name.span, words("it is defined here"));
            match &definition.value.kind {
                ExpressionKind::Name { name: state, order } if action.order == 0 => {
                    diagnostic.with_hint(words!("write `{} = ...`", primed(state, *order)))
                }
                _ => diagnostic.with_hint(words("change the states that it is computed from")),
            }
        }
        Some(Meaning::Parameter(_)) => error(words!("an event cannot change `{name}`: it is a parameter")),
        Some(Meaning::Independent | Meaning::Pi) => error(words!("an event cannot change `{name}`")),
        None => {
            let diagnostic = Diagnostic::error("unknown-name", words!("`{name}` is not known"), action.name.span);
            match declarations.scope.near(name) {
                Some(near) => diagnostic.with_hint(words!("did you mean `{}`?", primed(near, action.order))),
                None if action.order == 0 => {
                    diagnostic.with_hint(words!("declare it with its value at the start: `discrete {name} = 0`"))
                }
                None => diagnostic,
            }
        }
    })
}
