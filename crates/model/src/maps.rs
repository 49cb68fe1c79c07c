//! Iterated maps: with a discrete independent variable (`independent k by 1`), `next p = r*p*(1 - p)` gives p at the next
//! count.
//!
//! All maps become one event that fires at each count, so that all of them read the values before it. The quantities that
//! they set are discrete.

use crate::names::for_each;
use crate::notation::primed;
use crate::{
    Action, Diagnostic, EventExtras, Expression, ExpressionKind, Name, Span, Statement, StatementKind,
    syntax::expressions,
};
use std::borrow::Cow;
use std::collections::HashMap;
use units::words;

/// True if the independent variable is discrete.
pub(crate) fn counts(statements: &[Statement]) -> bool {
    statements.iter().any(|statement| matches!(statement.kind, StatementKind::Independent { counts: true, .. }))
}

/// Replaces all maps by one event.
pub(crate) fn write_out<'a>(
    statements: Cow<'a, [Statement]>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    if !counts(&statements) {
        if let Some((span, action)) = statements.iter().flat_map(next).next() {
            diagnostics.push(in_a_flow(span, action));
        }
        return statements;
    }
    refuse_rates(&statements, diagnostics);
    let mut targets: HashMap<&str, Span> = HashMap::new();
    for (span, Action { name, .. }) in statements.iter().flat_map(next) {
        if let Some(first) = targets.insert(&name.text, name.span) {
            let message = words!("the next value of `{}` is given twice", name.text);
            diagnostics.push(
                Diagnostic::error("duplicate-next", message, span)
                    .with_label(first, words("first here"))
                    .with_hint(words("keep one of them")),
            );
        }
    }
    for (_, Action { name, .. }) in statements.iter().flat_map(next) {
        let gives = |statement: &Statement| match &statement.kind {
            StatementKind::InitialValue { name: own, order: 0, .. }
            | StatementKind::Discrete { name: own, .. }
            // A later check reports that these cannot be changed.
            | StatementKind::Definition { name: own, .. } => own.text == name.text,
            StatementKind::Parameter(parameter) => parameter.name.text == name.text,
            _ => false,
        };
        if !statements.iter().any(gives) {
            let message = words!("`{}(0)` is not given", name.text);
            diagnostics.push(
                Diagnostic::error("missing-initial-value", message, name.span)
                    .with_hint(words!("{}(0) = 0", name.text)),
            );
        }
    }
    let mut event: Option<usize> = None;
    let mut written: Vec<Statement> = Vec::with_capacity(statements.len());
    for statement in statements.iter() {
        if let Some((span, _)) = next(statement).next() {
            let place = *event.get_or_insert_with(|| {
                written.push(Statement::of(each_count(span), statement.span));
                written.len() - 1
            });
            if let Some(StatementKind::Event { actions, .. }) = written.get_mut(place).map(|event| &mut event.kind) {
                actions.extend(next(statement).map(|(_, action)| action.clone()));
            }
            continue;
        }
        let mut statement = statement.clone();
        if let StatementKind::InitialValue { name, order: 0, value, unit } = &statement.kind
            && targets.contains_key(name.text.as_str())
        {
            statement.kind = StatementKind::discrete(name.clone(), value.clone(), unit.clone());
        }
        written.push(statement);
    }
    for statement in statements.iter() {
        // The label of a quantity may also stand at its next value.
        let Some(label) = &statement.label else { continue };
        let named = |other: &Name| next(statement).any(|(_, action)| action.name.text == other.text);
        for other in &mut written {
            if matches!(&other.kind, StatementKind::Discrete { name, .. } if named(name)) {
                other.label.get_or_insert_with(|| label.clone());
            }
        }
    }
    Cow::Owned(written)
}

/// The assignments of `next p = ...` with the span of the statement; a vector has one per component.
fn next(statement: &Statement) -> impl Iterator<Item = (Span, &Action)> {
    let actions = match &statement.kind {
        StatementKind::Event { actions, extras: EventExtras { next: true, .. }, .. } => actions.as_slice(),
        _ => &[],
    };
    actions.iter().map(|action| (statement.span, action))
}

/// The empty event `every 1 { }`.
fn each_count(span: Span) -> StatementKind {
    let condition = Expression::nothing(span);
    let extras = EventExtras { every: Some(Box::new((Expression::number(1.0, span), None))), ..EventExtras::default() };
    StatementKind::Event { condition, actions: Vec::new(), extras }
}

fn in_a_flow(span: Span, action: &Action) -> Diagnostic {
    let name = &action.name.text;
    let message = words("`next` needs an independent variable that counts; here it flows");
    let value = crate::notation::quote(&action.value);
    Diagnostic::error("next-in-a-flow", message, span)
        .with_hint(words!(
            "for a map write `independent k by 1`"
        ))
        .with_hint(words!(
            "for a change at equal intervals beside what flows: `discrete {name} = ...` and `every 1 [s] {{ {name} = {value} }}`"
        ))
}

/// Reports the first derivative in the model: between two counts there is no rate of change.
fn refuse_rates(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) {
    let mut found: Option<(Span, String, u32)> = None;
    let mut note = |span: Span, name: &str, order: u32| {
        if order > 0 && found.is_none() {
            found = Some((span, name.to_owned(), order));
        }
    };
    for statement in statements {
        match &statement.kind {
            StatementKind::InitialValue { name, order, .. } => note(name.span, &name.text, *order),
            StatementKind::Event { actions, .. } => {
                actions.iter().for_each(|action| note(action.name.span, &action.name.text, action.order));
            }
            _ => {}
        }
        for expression in expressions(statement) {
            for_each(expression, |part| {
                if let ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } = &part.kind
                    && !name.contains('.')
                {
                    note(part.span, name, *order);
                }
            });
        }
    }
    let Some((span, name, order)) = found else { return };
    let message = words!("`{}` is a rate of change, and here the independent variable counts", primed(&name, order));
    diagnostics.push(
        Diagnostic::error("rate-in-a-map", message, span)
            .with_hint(words!("give the value at the next count: next {name} = ...")),
    );
}
