//! Errors about vectors, with hints.

use super::known::{CROSS, DOT, NORM, axes};
use crate::notation::quote;
use crate::{Diagnostic, Expression, ExpressionKind, Span};
use units::words;

/// Error for a vector in place of a number.
pub(super) fn vector_for_number(expression: &Expression) -> Diagnostic {
    let written = quote(expression);
    let message = words!("a number is needed here, but `{written}` is a vector");
    let diagnostic = Diagnostic::error("vector-for-number", message, expression.span);
    match &expression.kind {
        ExpressionKind::Tuple { parts, .. } if is_decimal_comma(parts) => with_point(diagnostic, expression),
        ExpressionKind::Tuple { .. } => diagnostic
            .with_hint(words("its magnitude is norm(...); to call a function, write its name before the parenthesis")),
        ExpressionKind::Name { name, .. } => {
            diagnostic.with_hint(words!("write a component, {name}.x, or the magnitude, norm({name})"))
        }
        _ => diagnostic.with_hint(words("the magnitude of a vector is norm(...), the scalar product dot(..., ...)")),
    }
}

/// True for `(2,5)` with a comma directly between digits.
fn is_decimal_comma(parts: &[Expression]) -> bool {
    let number = |part: &Expression| matches!(part.kind, ExpressionKind::Number { unit: None, .. });
    matches!(parts, [whole, rest] if number(whole) && number(rest) && whole.span.end + 1 == rest.span.start)
}

/// Error for a number in place of a vector.
pub(super) fn number_for_vector(name: &str, dimension: usize, value: &Expression) -> Diagnostic {
    let message = words!("`{name}` is a vector, but this is a number");
    Diagnostic::error("number-for-vector", message, value.span)
        .with_hint(words!("a vector is written by its components: ({})", axes(dimension)))
}

/// Error for a sum, equation or branch with a vector and a number.
pub(super) fn vector_and_number(vector: &Expression, number: &Expression) -> Diagnostic {
    let (one, other) = (quote(vector), quote(number));
    let message = words!("`{one}` is a vector, but `{other}` is a number");
    Diagnostic::error("vector-and-number", message, number.span)
        .saying(words("a number"))
        .with_label(vector.span, words("a vector"))
        .with_hint(words(
            "vectors are added to vectors, component by component; a number can multiply or divide a vector",
        ))
}

/// Error for vectors with different numbers of components.
pub(super) fn different_dimensions(one: (&Expression, usize), other: (&Expression, usize)) -> Diagnostic {
    let message = words!("`{}` has {} components and `{}` has {}", quote(one.0), one.1, quote(other.0), other.1);
    Diagnostic::error("vector-components", message, other.0.span)
        .with_label(one.0.span, words!("{} components", one.1))
        .with_hint(words("give both 3 components: a vector in the plane has the third component 0"))
}

/// Error for `a*b` of two vectors.
pub(super) fn product(left: &Expression, right: &Expression, span: Span) -> Diagnostic {
    let (one, other) = (quote(left), quote(right));
    let message = words!("`{one}` and `{other}` are vectors: it is not clear which product is meant");
    Diagnostic::error("vector-product", message, span).with_hint(words!(
        "write dot({one}, {other}) for the scalar product or cross({one}, {other}) for the vector product"
    ))
}

/// Error for a division by a vector.
pub(super) fn division(by: &Expression) -> Diagnostic {
    let written = quote(by);
    let message = words!("`{written}` is a vector, and nothing can be divided by one");
    Diagnostic::error("vector-division", message, by.span)
        .with_hint(words!("divide by its magnitude, norm({written}), or by one of its components"))
}

/// Error for `r^2`.
pub(super) fn power(base: &Expression, span: Span) -> Diagnostic {
    let written = quote(base);
    let message = words!("`{written}` is a vector, and vectors have no powers");
    Diagnostic::error("vector-power", message, span)
        .with_hint(words!("the square of its magnitude is norm({written})^2 or dot({written}, {written})"))
}

/// Adds a hint about the decimal point if the vector is only a number with a decimal comma.
fn with_point(diagnostic: Diagnostic, vector: &Expression) -> Diagnostic {
    match &vector.kind {
        ExpressionKind::Tuple { parts, .. } if is_decimal_comma(parts) => {
            diagnostic.with_hint(words("a number has a decimal point here, not a comma"))
        }
        _ => diagnostic,
    }
}

/// Error for `a < b` and `a == b` of vectors.
pub(super) fn comparison(vector: &Expression, span: Span) -> Diagnostic {
    let written = quote(vector);
    let message = words!("`{written}` is a vector, and vectors are not compared");
    with_point(Diagnostic::error("vector-comparison", message, span), vector)
        .with_hint(words!("compare magnitudes, norm({written}), or components"))
}

/// Error for a vector in a function of numbers.
pub(super) fn in_function(function: &str, vector: &Expression) -> Diagnostic {
    let written = quote(vector);
    let message = words!("`{function}` takes numbers, but `{written}` is a vector");
    let diagnostic = with_point(Diagnostic::error("vector-in-function", message, vector.span), vector);
    match function {
        "abs" | "mag" | "length" => diagnostic.with_hint(words!("the magnitude of a vector is norm({written})")),
        "hat" | "unit" | "normalize" => diagnostic.with_hint(words!("the unit vector is {written}/norm({written})")),
        "coulomb" => diagnostic.with_hint(words(
            "dry friction acts along a line: write the equation of each component, such as r.x'' = ...",
        )),
        _ => diagnostic.with_hint(words!("apply it to a component or to the magnitude, norm({written})")),
    }
}

/// Error for `norm(2)`.
pub(super) fn number_in_operation(function: &str, argument: &Expression) -> Diagnostic {
    let written = quote(argument);
    let message = words!("`{function}` takes vectors, but `{written}` is a number");
    let diagnostic = Diagnostic::error("number-in-vector-function", message, argument.span);
    match function {
        NORM => diagnostic.with_hint(words!("the magnitude of a number is abs({written})")),
        DOT | CROSS => diagnostic.with_hint(words("a number and a vector are multiplied with *")),
        _ => diagnostic,
    }
}

/// Error for `norm(a, b)`.
pub(super) fn wrong_count(function: &str, takes: usize, given: usize, span: Span) -> Diagnostic {
    let vectors = if takes == 1 { words("1 vector") } else { words("2 vectors") };
    let message = words!("`{function}` takes {vectors}, but there are {given} arguments");
    Diagnostic::error("wrong-argument-count", message, span)
}

/// Error for `r.z` in the plane, and for `r.w`.
pub(super) fn no_component(vector: &str, member: &str, dimension: usize, span: Span) -> Diagnostic {
    let axes = axes(dimension);
    let message = words!("the vector `{vector}` has no component {member}");
    let diagnostic = Diagnostic::error("no-component", message, span).with_note(words!("its components are {axes}"));
    if dimension == 2 && member == "z" {
        return diagnostic
            .with_hint(words!("for a vector in space give all three where `{vector}` gets its value: (..., ..., 0)"));
    }
    diagnostic
}

/// Error for `(a*b).x` of numbers.
pub(super) fn component_of_number(of: &Expression, whole: &Expression) -> Diagnostic {
    let written = quote(of);
    let message = words!("`{written}` is a number and has no components");
    Diagnostic::error("component-of-number", message, whole.span)
}

/// Error for `r.x = 2` of a vector.
pub(super) fn component_defined(name: &str, vector: &str, dimension: usize, span: Span) -> Diagnostic {
    let message = words!("`{name}` is a component of the vector `{vector}` and cannot be defined by itself");
    Diagnostic::error("component-defined", message, span)
        .with_hint(words!("define all of it: {vector} = ({})", axes(dimension)))
}

/// Error for a name that is a vector and something else.
pub(super) fn taken(name: &str, other: &units::Words, span: Span) -> Diagnostic {
    let message = words!("`{name}` cannot be a vector: it is {other}");
    Diagnostic::error("duplicate-name", message, span).with_hint(words("give one of them another name"))
}
