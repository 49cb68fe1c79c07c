//! The default values of parameters.

use super::{Edit, EditError, layout};
use crate::outline::Outline;
use model::{ExpressionKind, ParameterForm, ParameterStatement, Span, StatementKind};

/// Replaces the default value of a parameter by `text`, a number in the declared unit. Unit, range, label and comment
/// stay; so does the column of what follows the value, if there is space and other lines show that it is aligned. `name`
/// is the ASCII name; of several parameters of one name, the first is changed. Whether the value lies in the range is
/// not checked.
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
    let Some(parameter) = parameters(outline).find(|parameter| parameter.name.text == name) else {
        return Err(EditError::UnknownParameter(name.to_owned()));
    };
    if parameter.value.is_nan() {
        return Err(EditError::UnreadableParameter(name.to_owned()));
    }
    let source = outline.source();
    let mut edit = Edit { span: parameter.value_span, text: text.to_owned() };
    if let Some(follower) = Follower::of(source, edit.span) {
        let (old, new) = (source[edit.span.range()].chars().count(), text.chars().count());
        let spare = follower.blanks.saturating_sub(1);
        let is_aligned = || {
            let others = parameters(outline).filter(|other| other.value_span != edit.span);
            let mut others = others.filter_map(|other| Follower::of(source, other.value_span));
            spare > 0 || others.any(|other| other.column == follower.column)
        };
        if new > old {
            edit.span.end += spare.min(new - old);
        } else if is_aligned() {
            edit.text.extend(std::iter::repeat_n(' ', old - new));
        }
    }
    layout::result(outline, std::slice::from_ref(&edit))?;
    Ok(edit)
}

fn parameters<'a>(outline: &'a Outline) -> impl Iterator<Item = &'a ParameterStatement> {
    let statements = outline.blocks().iter().flat_map(|block| &block.statements);
    statements.filter_map(|statement| match &statement.kind {
        StatementKind::Parameter(parameter) if parameter.form == ParameterForm::Number => Some(parameter),
        _ => None,
    })
}

/// What follows a value on its line.
struct Follower {
    /// How many blanks are between.
    blanks: usize,
    /// The characters before it on the line.
    column: usize,
}

impl Follower {
    /// None if the line ends after the value.
    fn of(source: &str, value: Span) -> Option<Self> {
        let rest = &source[value.end..];
        let blanks = rest.len() - rest.trim_start_matches(' ').len();
        if rest[blanks..].is_empty() || rest[blanks..].starts_with(['\r', '\n']) {
            return None;
        }
        let start = source[..value.start].rfind('\n').map_or(0, |at| at + 1);
        Some(Self { blanks, column: source[start..value.end + blanks].chars().count() })
    }
}

/// Whether the model language reads a text as one number, with or without a sign.
fn is_number(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+', '−', '–']).unwrap_or(text);
    let (expression, unit, found) = model::parse_expression(digits, 0..digits.len());
    digits.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && matches!(expression.kind, ExpressionKind::Number { unit: None, .. })
        && expression.span == Span::new(0, digits.len())
        && unit.is_none()
        && found.is_empty()
}
