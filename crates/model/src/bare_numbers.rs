//! A bare number that is assigned to a quantity is in the declared unit of the quantity, as in its range and on the command
//! line.

use crate::{Diagnostic, Expression, ExpressionKind, Span, Statement, StatementKind, UnaryOperator};
use std::borrow::Cow;
use std::collections::HashMap;
use units::number::shortest;
use units::{Unit, words};

/// Returns `value` with the declared unit of `name` if it is a bare number, or else unchanged. If the unit is not the
/// coherent SI unit, a warning shows both readings of the number.
pub fn in_declared_unit(
    name: &str,
    mut value: Expression,
    unit: &Unit,
    diagnostics: &mut Vec<Diagnostic>,
) -> Expression {
    let Some(number) = value.bare_number() else { return value };
    if number != 0.0 && !unit.is_coherent() {
        diagnostics.push(remark(name, &value, number, unit));
    }
    value.kind = ExpressionKind::Number { value: number, unit: Some(unit.clone()) };
    value
}

fn remark(name: &str, value: &Expression, number: f64, unit: &Unit) -> Diagnostic {
    let span = value.span;
    let (declared, coherent) = (format!("{} [{unit}]", shortest(number)), si(number, unit));
    let message = words!("a bare number is in the unit in which `{name}` is declared: here `{declared}`");
    let diagnostic = Diagnostic::warning("bare-number", message, span)
        .with_note(words!("as a number in SI units it would be `{coherent}`"))
        .with_hint(words!("state the unit: `{declared}`"))
        .with_hint(words!("if the SI value is meant, write `{coherent}`"));
    let is_literal = match &value.kind {
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => matches!(operand.kind, ExpressionKind::Number { .. }),
        kind => matches!(kind, ExpressionKind::Number { .. }),
    };
    match is_literal {
        true => diagnostic.with_fix(span.after(), format!(" [{unit}]")),
        false => diagnostic.with_fix(span, declared),
    }
    .with_fix(span, coherent)
}

/// A number in `unit` as text in SI units: in radians for an angle, in the declared unit for another dimensionless number.
fn si(number: f64, unit: &Unit) -> String {
    if !unit.dimension.is_none() {
        return format!("{} [{}]", shortest(number), Unit::si(unit.dimension));
    }
    if is_degree(unit) {
        return format!("{} [rad]", shortest(number));
    }
    format!("{} [{unit}]", shortest(unit.from_si(number)))
}

/// True for degrees, in either spelling.
fn is_degree(unit: &Unit) -> bool {
    matches!(unit.text.as_str(), "deg" | "°")
}

/// Gives the declared unit to each bare number that an event or a button assigns to a dimensionless quantity: `theta = 90`
/// after `theta(0) = 0 in [deg]`. Borrows the statements if nothing changes.
pub(crate) fn write_out<'a>(
    statements: Cow<'a, [Statement]>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    let declared: HashMap<(&str, u32), &Unit> = statements.iter().filter_map(declared).collect();
    let is_given = |statement: &Statement| match &statement.kind {
        StatementKind::Event { actions, .. } => {
            actions.iter().any(|action| declared.contains_key(&(action.name.text.as_str(), action.order)))
        }
        _ => false,
    };
    if !statements.iter().any(is_given) {
        return statements;
    }
    let mut written = statements.to_vec();
    for statement in &mut written {
        let StatementKind::Event { actions, .. } = &mut statement.kind else { continue };
        for action in actions {
            if let Some(unit) = declared.get(&(action.name.text.as_str(), action.order)) {
                let value = std::mem::replace(&mut action.value, Expression::nothing(Span::default()));
                action.value = in_declared_unit(&action.name.text, value, unit, diagnostics);
            }
        }
    }
    Cow::Owned(written)
}

/// Name, derivative order and unit that a statement declares, if the unit is dimensionless and not 1.
fn declared(statement: &Statement) -> Option<((&str, u32), &Unit)> {
    let (name, order, unit) = match &statement.kind {
        StatementKind::InitialValue { name, order, unit, .. } => (name, *order, unit.as_ref()?),
        StatementKind::Discrete { name, unit, .. } => (name, 0, unit.as_ref()?),
        _ => return None,
    };
    let unit = &unit.unit;
    (unit.dimension.is_none() && !unit.is_coherent()).then_some(((name.text.as_str(), order), unit))
}
