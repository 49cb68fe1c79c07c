//! Functions and derivatives in the notation of other languages.

use super::scope::{Meaning, Scope};
use super::traverse::for_each;
use crate::notation::{primed, quote};
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Name, Span};
use program::AggregateKind;
use program::functions::Function;
use units::{Words, words};

/// Derivative functions of other languages.
const DERIVATIVES: [&str; 5] = ["der", "diff", "deriv", "derivative", "D"];

/// Vector constructors of other languages.
const VECTORS: [&str; 7] = ["vector", "vec", "Vector", "vec2", "vec3", "Vec2", "Vec3"];

/// Delays of other languages.
const LATE: [&str; 5] = ["delay", "delayed", "lag", "retardo", "retraso"];

/// Advice for an equation with a delay.
fn follows_late(name: &str) -> Words {
    words!(
        "a quantity that follows `{name}` late: `z' = ({name} - z)/tau`, with a name of your own and its value at the start"
    )
}

/// Error for a value at another time, `y(t - tau)`; `None` if the argument does not contain the independent variable.
pub(super) fn at_another_time(scope: &Scope, name: &Name, argument: &Expression, span: Span) -> Option<Diagnostic> {
    let text = &name.text;
    let varies = matches!(scope.meaning(text), Some(Meaning::Variable(_) | Meaning::Definition(_)));
    let mut has_time = false;
    for_each(argument, |part| {
        if let ExpressionKind::Name { name, order: 0 } = &part.kind {
            has_time |= matches!(scope.meaning(name), Some(Meaning::Independent));
        }
    });
    (varies && has_time).then(|| {
        let wrong = words!("`{text}` at another time cannot be used: the equations have no delays");
        Diagnostic::error("unknown-function", wrong, span).with_hint(follows_late(text))
    })
}

/// Advice about a function that does not exist here.
pub(super) fn instead_of(scope: &Scope, function: &Name, arguments: &[Expression]) -> Option<Words> {
    let text = &function.text;
    if Function::named(text).is_some() {
        return None;
    }
    let name = match arguments {
        [Expression { kind: ExpressionKind::Name { name, order: 0 }, .. }, ..] => Some(name),
        _ => None,
    };
    if DERIVATIVES.contains(&text.as_str()) {
        let name = name.map_or("x", String::as_str);
        return Some(words!("the derivative of `{name}` is written `{name}'`"));
    }
    if VECTORS.contains(&text.as_str()) {
        return Some(words("a vector is its components in parentheses: `(1, 0, 0)`"));
    }
    if ["norm", "dot", "cross"].contains(&text.as_str()) {
        return Some(words!("`{text}` is for vectors, and here is none: one is defined as in `r = (x, y)`"));
    }
    if LATE.contains(&text.as_str()) {
        let name = name.map_or("y", String::as_str);
        return Some(follows_late(name));
    }
    let name = name.filter(|_| arguments.len() == 1)?;
    matches!(scope.meaning(name), Some(Meaning::Independent))
        .then(|| words!("write `{text}` alone: every quantity may depend on `{name}`"))
}

/// Error for `maximum(x)` in a place where it is not defined, and for `maximum(a, b)`.
pub(super) fn of_runs(function: &Name, arguments: &[Expression]) -> Option<Diagnostic> {
    let text = &function.text;
    let kind = AggregateKind::named(text)?;
    let [argument] = arguments else {
        let count = arguments.len();
        let message = words!("`{text}` takes 1 argument, and {count} were given");
        let of_several = match kind {
            AggregateKind::Maximum => Some(words("the greatest of several numbers is `max(a, b)`")),
            AggregateKind::Minimum => Some(words("the least of several numbers is `min(a, b)`")),
            AggregateKind::Mean | AggregateKind::Integral => None,
        };
        let diagnostic = Diagnostic::error("wrong-argument-count", message, function.span);
        return Some(match of_several {
            Some(hint) => diagnostic.with_hint(hint),
            None => diagnostic,
        });
    };
    let name = match &argument.kind {
        ExpressionKind::Name { name, order: 0 } => name.as_str(),
        _ => "x",
    };
    let message = words!("`{text}` cannot stand here: it is taken of a run, and here is one moment of it");
    Some(
        Diagnostic::error("unknown-function", message, function.span)
            .with_hint(words!("a run remembers only what the model asks for: write `{name}_1 = {text}({name})` there")),
    )
}

/// `y'` for `diff(y)` and `diff(y, t)`.
pub(super) fn derivative_of(function: &Name, arguments: &[Expression]) -> Option<String> {
    let first = arguments.first().filter(|_| DERIVATIVES.contains(&function.text.as_str()))?;
    match &first.kind {
        ExpressionKind::Name { name, order } => Some(primed(name, order + 1)),
        _ => None,
    }
}

/// Errors for derivatives written as quotients: `dx/dt`, `d2x/dt^2`.
pub(crate) fn quotients(scope: &Scope, expression: &Expression) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for_each(expression, |part| {
        let ExpressionKind::Binary(BinaryOperator::Divide, above, below) = &part.kind else { return };
        // In `m*d2x/dt2` the numerator is a product.
        let above = match &above.kind {
            ExpressionKind::Binary(BinaryOperator::Multiply, _, last) => last,
            _ => above,
        };
        if let Some((variable, order)) = derivative(scope, above, below) {
            let span = above.span.to(below.span);
            let (written, ours) = (format!("{}/{}", quote(above), quote(below)), primed(variable, order));
            let message = words!("`{written}` is written `{ours}` here");
            found.push(Diagnostic::error("foreign-derivative", message, span).with_fix(span, ours));
        }
    });
    found
}

/// Variable and order of a derivative written as a quotient, if the names have no other meaning.
fn derivative<'a>(scope: &Scope, above: &'a Expression, below: &Expression) -> Option<(&'a str, u32)> {
    let ExpressionKind::Name { name: above, order: 0 } = &above.kind else { return None };
    let (below, power) = match &below.kind {
        ExpressionKind::Binary(BinaryOperator::Power, base, exponent) => match (&base.kind, &exponent.kind) {
            (ExpressionKind::Name { name, order: 0 }, ExpressionKind::Number { value, unit: None }) => (name, *value),
            _ => return None,
        },
        ExpressionKind::Name { name, order: 0 } => (name, 1.0),
        _ => return None,
    };
    let below = below.strip_prefix('d')?.strip_prefix(&*scope.independent)?;
    if scope.meaning(above).is_some() || !(below.is_empty() || below.parse::<u32>().is_ok()) {
        return None;
    }
    let variable = above.strip_prefix('d')?.trim_start_matches(|character: char| character.is_ascii_digit());
    let order = if below.is_empty() { power } else { below.parse().ok()? };
    (!variable.is_empty() && (1.0..=4.0).contains(&order)).then_some((variable, order as u32))
}
