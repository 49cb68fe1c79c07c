//! Warnings about angles that look like degrees but are in radians: `theta(0) = 45`, `parameter alpha = 30 in 0..90`.

use crate::names::{Declarations, for_each};
use crate::{BinaryOperator, Bounds, Diagnostic, Expression, ExpressionKind, ParameterForm, Span};
use std::collections::HashSet;
use std::f64::consts::TAU;
use units::number::shortest;
use units::words;

/// Common names of angles, without index and accents.
const NAMES: [&str; 10] =
    ["theta", "phi", "psi", "angle", "angulo", "inclination", "inclinacion", "latitude", "latitud", "grados"];

/// Common ends of ranges in degrees.
const ENDS: [f64; 14] = [15.0, 30.0, 40.0, 45.0, 60.0, 70.0, 75.0, 80.0, 85.0, 89.0, 90.0, 180.0, 270.0, 360.0];

/// Maximum number of definitions and initial values followed from the argument of a sine to the numbers behind it.
const STEPS: usize = 4;

/// Largest number that is taken as a factor of an angle, as in `2*theta` and `theta/2`, and not as a unit conversion.
const GREATEST_FACTOR: f64 = 8.0;

/// Warns of each parameter and initial value without a unit that is an angle and looks like degrees.
pub(crate) fn remark_on_degrees(declarations: &Declarations, diagnostics: &mut Vec<Diagnostic>) {
    let angles = angles(declarations);
    let is_angle = |name: &str| angles.contains(name) || is_called_angle(name);
    for entry in &declarations.parameters {
        let own = entry.statement;
        let is_bare = own.unit.is_none() && own.form == ParameterForm::Number;
        let range = own.range.as_ref();
        if is_bare && is_angle(&own.name.text) && (own.value.abs() > TAU || range.is_some_and(looks_like_degrees)) {
            diagnostics.push(remark(&own.name.text, own.value, own.value_span));
        }
    }
    for entry in &declarations.initial_values {
        let number = entry.value.bare_number().filter(|number| number.abs() > TAU);
        if let Some(number) = number.filter(|_| entry.order == 0 && is_angle(&entry.name.text)) {
            diagnostics.push(remark(&entry.name.text, number, entry.value.span));
        }
    }
}

fn looks_like_degrees(range: &Bounds) -> bool {
    let is_end = |end: f64| ENDS.contains(&end.abs());
    let greatest = range.low.abs().max(range.high.abs());
    is_end(greatest) && (range.low == 0.0 || is_end(range.low) || range.low.abs() <= 10.0)
}

fn is_called_angle(name: &str) -> bool {
    let stem = name.split('_').next().unwrap_or_default().trim_end_matches(|c: char| c.is_ascii_digit());
    let plain: String = stem.chars().map(units::alphabet::without_accent).collect();
    NAMES.contains(&plain.to_lowercase().as_str())
}

/// Names whose values are angles: the arguments of sines, cosines and tangents, and the names that these are computed from.
fn angles<'a>(declarations: &Declarations<'a>) -> HashSet<&'a str> {
    let definitions = || declarations.definitions.iter().map(|one| (one.name.text.as_str(), one.value));
    let initial = || declarations.initial_values.iter().filter(|one| one.order == 0);
    let mut found = HashSet::new();
    let equations = declarations.equations.iter().flat_map(|equation| [equation.left, equation.right]);
    let values = definitions().map(|(_, value)| value).chain(declarations.initial_values.iter().map(|one| one.value));
    let events = declarations.events.iter();
    let events = events.flat_map(|event| event.actions.iter().map(|action| &action.value).chain([event.condition]));
    for expression in equations.chain(values).chain(events) {
        for_each(expression, |part| {
            if let ExpressionKind::Call { function, arguments } = &part.kind
                && let ("sin" | "cos" | "tan", [argument]) = (function.text.as_str(), arguments.as_slice())
            {
                terms(argument, &mut found);
            }
        });
    }
    for _ in 0..STEPS {
        let known = found.len();
        let given = definitions().chain(initial().map(|one| (one.name.text.as_str(), one.value)));
        let values: Vec<_> = given.filter(|(name, _)| found.contains(name)).map(|(_, value)| value).collect();
        values.into_iter().for_each(|value| terms(value, &mut found));
        if found.len() == known {
            break;
        }
    }
    found
}

/// Collects the names of the terms of an angle, also with small factors. Names that are converted or multiplied by other
/// quantities are left out.
fn terms<'a>(angle: &'a Expression, found: &mut HashSet<&'a str>) {
    let mut waiting = vec![angle];
    while let Some(next) = waiting.pop() {
        let is_factor = |one: &Expression| one.bare_number().is_some_and(|number| number.abs() <= GREATEST_FACTOR);
        match &next.kind {
            ExpressionKind::Name { name, order: 0 } | ExpressionKind::InitialValue { name, order: 0 } => {
                found.insert(name.as_str());
            }
            ExpressionKind::Unary(_, operand) => waiting.push(operand),
            ExpressionKind::Binary(BinaryOperator::Add | BinaryOperator::Subtract, left, right) => {
                waiting.extend([&**left, &**right]);
            }
            ExpressionKind::Binary(BinaryOperator::Multiply, left, right) if is_factor(left) => waiting.push(right),
            ExpressionKind::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, left, right)
                if is_factor(right) =>
            {
                waiting.push(left);
            }
            ExpressionKind::If(_, chosen, other) => waiting.extend([&**chosen, &**other]),
            ExpressionKind::Expansion(expansion) => waiting.push(&expansion.body),
            _ => {}
        }
    }
}

fn remark(name: &str, number: f64, span: Span) -> Diagnostic {
    let number = shortest(number);
    Diagnostic::warning("radians", words!("`{name}` is an angle, and without a unit its numbers are radians"), span)
        .with_hint(words!("for degrees write `{number} [deg]`"))
        .with_hint(words!("if radians are meant, write `{number} [rad]`"))
        .with_fix(span.after(), " [deg]")
        .with_fix(span.after(), " [rad]")
}
