//! What events may change: states, and nothing else.

use super::program::{EventEntry, Program};
use super::scope::Meaning;
use super::unknowns::Unknown;
use crate::notation::{primed, quote};
use crate::{Action, BinaryOperator, Diagnostic, ExpressionKind};

/// Checks the names on the left of the actions of an event, and that its condition can become true.
pub(crate) fn check_event(
    program: &Program,
    unknowns: &[Unknown],
    event: &EventEntry,
    diagnostics: &mut Vec<Diagnostic>,
) {
    if let ExpressionKind::Binary(BinaryOperator::Equal, left, right) = &event.condition.kind {
        let (left, right) = (quote(left), quote(right));
        diagnostics.push(
            Diagnostic::warning(
                "event-at-equality",
                "this is hardly ever true exactly, so the event may never fire",
                event.condition.span,
            )
            .with_hint(format!("write `{left} < {right}` or `{left} > {right}`: the event is where it becomes true")),
        );
    }
    for (index, action) in event.actions.iter().enumerate() {
        if let Some(diagnostic) = check_action(program, unknowns, action) {
            diagnostics.push(diagnostic);
        }
        let is_same = |other: &&Action| other.name.text == action.name.text && other.order == action.order;
        if let Some(first) = event.actions[..index].iter().find(is_same) {
            let message = format!("the event changes `{}` twice", primed(&action.name.text, action.order));
            diagnostics.push(
                Diagnostic::error("duplicate-action", message, action.name.span)
                    .with_label(first.name.span, "first here")
                    .with_note("all actions of an event use the values before it"),
            );
        }
    }
}

fn check_action(program: &Program, unknowns: &[Unknown], action: &Action) -> Option<Diagnostic> {
    let name = &action.name.text;
    let written = primed(name, action.order);
    let error = |message: String| Diagnostic::error("event-changes-no-state", message, action.name.span);
    Some(match program.scope.meaning(name) {
        Some(Meaning::Variable(index)) => {
            let unknown = &unknowns[index];
            if action.order < unknown.highest {
                return None;
            }
            error(format!("an event cannot change `{written}`: the equations determine it"))
                .with_label(unknown.span, "it is determined here")
                .with_hint(format!("change `{}` instead", primed(name, unknown.highest - 1)))
        }
        Some(Meaning::Definition(index)) => {
            let definition = &program.definitions[index];
            let diagnostic = error(format!("an event cannot change `{written}`: `{name}` is defined by an expression"))
                .with_label(definition.name.span, "it is defined here");
            match &definition.value.kind {
                ExpressionKind::Name { name: state, order } if action.order == 0 => {
                    diagnostic.with_hint(format!("write `{} = ...`", primed(state, *order)))
                }
                _ => diagnostic.with_hint("change the states that it is computed from"),
            }
        }
        Some(Meaning::Parameter(_)) => error(format!("an event cannot change `{name}`: it is a parameter")),
        Some(Meaning::Independent | Meaning::Pi) => error(format!("an event cannot change `{name}`")),
        None => {
            let diagnostic = Diagnostic::error("unknown-name", format!("`{name}` is not known"), action.name.span);
            match program.scope.near(name) {
                Some(near) => diagnostic.with_hint(format!("did you mean `{}`?", primed(near, action.order))),
                None => diagnostic,
            }
        }
    })
}
