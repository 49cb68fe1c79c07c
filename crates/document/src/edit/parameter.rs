//! Edits of default values of parameters, and of values of sizes.

use super::columns::keeping_columns;
use super::{Edit, EditError, layout};
use crate::text::outline::Outline;
use model::{ExpressionKind, ParameterForm, Span, StatementKind};

/// Replaces the default value of a parameter by `text`, a number in the declared unit, or the value of a size. Unit, range,
/// label and comment are kept. The rest of the line stays in its column if there is space and other lines show that it is
/// aligned. `name` is the ASCII name; of several parameters with one name, the first is changed. The range is not checked.
///
/// # Errors
///
/// [`EditError::NotANumber`], [`EditError::UnknownParameter`], [`EditError::UnreadableParameter`] and
/// [`EditError::TooLong`].
pub fn set_parameter(outline: &Outline, name: &str, text: &str) -> Result<Edit, EditError> {
    let text = text.trim();
    if !is_number(text) {
        return Err(EditError::NotANumber(text.to_owned()));
    }
    let Some((_, span)) = values(outline).find(|(known, _)| *known == name) else {
        return Err(EditError::UnknownParameter(name.to_owned()));
    };
    let Some(span) = span else {
        return Err(EditError::UnreadableParameter(name.to_owned()));
    };
    let others = values(outline).filter_map(|(_, span)| span);
    let edit = keeping_columns(outline.source(), Edit { span, text: text.to_owned() }, others);
    layout::result(outline, std::slice::from_ref(&edit))?;
    Ok(edit)
}

/// Names of parameters and sizes, with the places of their values; `None` for an invalid value.
fn values<'a>(outline: &'a Outline) -> impl Iterator<Item = (&'a str, Option<Span>)> {
    let statements = outline.blocks().iter().flat_map(|block| &block.statements);
    statements.filter_map(|statement| match &statement.kind {
        StatementKind::Parameter(parameter) if parameter.form == ParameterForm::Number => {
            Some((parameter.name.text.as_str(), (!parameter.value.is_nan()).then_some(parameter.value_span)))
        }
        StatementKind::Size(size) => Some((size.name.text.as_str(), Some(size.value_span))),
        _ => None,
    })
}

/// True if the text is one number in the model language, with or without a sign.
fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+', '−', '–']).unwrap_or(text);
    let (expression, unit, found) = model::parse_expression(digits, 0..digits.len());
    digits.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && matches!(expression.kind, ExpressionKind::Number { unit: None, .. })
        && expression.span == Span::new(0, digits.len())
        && unit.is_none()
        && found.is_empty()
}
