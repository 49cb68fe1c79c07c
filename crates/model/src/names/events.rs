//! What events may change: states, and nothing else.

use super::declarations::{Declarations, EventEntry};
use super::scope::Meaning;
use super::unknown::Unknown;
use crate::notation::{primed, quote};
use crate::{Action, BinaryOperator, Diagnostic, ExpressionKind};
use units::{Words, words};

/// Checks the names on the left of the actions of an event, and that its condition can become true.
pub(crate) fn check_event(
    declarations: &Declarations,
    unknowns: &[Unknown],
    event: &EventEntry,
    diagnostics: &mut Vec<Diagnostic>,
) {
    if let ExpressionKind::Binary(BinaryOperator::Equal, left, right) = &event.condition.kind {
        let (left, right) = (quote(left), quote(right));
        diagnostics.push(
            Diagnostic::warning(
                "event-at-equality",
                words(
                    "this is hardly ever true exactly, so the event may never fire",
                    "esto casi nunca se cumple exactamente: puede que el evento no ocurra nunca",
                ),
                event.condition.span,
            )
            .with_hint(words!(
                "write `{left} < {right}` or `{left} > {right}`: the event is where it becomes true",
                "escribe `{left} < {right}` o `{left} > {right}`: el evento está donde pasa a ser verdadero"
            )),
        );
    }
    for (index, action) in event.actions.iter().enumerate() {
        if let Some(diagnostic) = check_action(declarations, unknowns, action) {
            diagnostics.push(diagnostic);
        }
        let is_same = |other: &&Action| other.name.text == action.name.text && other.order == action.order;
        if let Some(first) = event.actions[..index].iter().find(is_same) {
            let message = words!(
                "the event changes `{}` twice",
                "el evento cambia `{}` dos veces",
                primed(&action.name.text, action.order)
            );
            diagnostics.push(
                Diagnostic::error("duplicate-action", message, action.name.span)
                    .with_label(first.name.span, words("first here", "primero aquí"))
                    .with_note(words(
                        "all actions of an event use the values before it",
                        "todas las acciones de un evento usan los valores anteriores a él",
                    )),
            );
        }
    }
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
            error(words!(
                "an event cannot change `{written}`: the equations determine it",
                "un evento no puede cambiar `{written}`: lo determinan las ecuaciones"
            ))
            .with_label(unknown.span, words("it is determined here", "se determina aquí"))
            .with_hint(words!(
                "change `{}` instead",
                "cambia `{}` en su lugar",
                primed(name, unknown.highest - 1)
            ))
        }
        Some(Meaning::Definition(index)) => {
            let definition = &declarations.definitions[index];
            let diagnostic = error(words!(
                "an event cannot change `{written}`: `{name}` is defined by an expression",
                "un evento no puede cambiar `{written}`: `{name}` se define con una expresión"
            ))
            .with_label(definition.name.span, words("it is defined here", "se define aquí"));
            match &definition.value.kind {
                ExpressionKind::Name { name: state, order } if action.order == 0 => {
                    diagnostic.with_hint(words!("write `{} = ...`", "escribe `{} = ...`", primed(state, *order)))
                }
                _ => diagnostic.with_hint(words(
                    "change the states that it is computed from",
                    "cambia los estados a partir de los que se calcula",
                )),
            }
        }
        Some(Meaning::Parameter(_)) => error(words!(
            "an event cannot change `{name}`: it is a parameter",
            "un evento no puede cambiar `{name}`: es un parámetro"
        )),
        Some(Meaning::Independent | Meaning::Pi) => {
            error(words!("an event cannot change `{name}`", "un evento no puede cambiar `{name}`"))
        }
        None => {
            let diagnostic = Diagnostic::error(
                "unknown-name",
                words!("`{name}` is not known", "no se conoce `{name}`"),
                action.name.span,
            );
            match declarations.scope.near(name) {
                Some(near) => diagnostic.with_hint(words!(
                    "did you mean `{}`?",
                    "¿querías decir `{}`?",
                    primed(near, action.order)
                )),
                None => diagnostic,
            }
        }
    })
}
