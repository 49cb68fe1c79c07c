//! Sections of a form.

use model::{ExpressionKind, Statement, StatementKind};

/// Sections of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Section {
    /// Parameters, switches, random seeds and sizes, and groups of their controls.
    Parameters,
    /// Quantities with initial values.
    InitialValues,
    /// Equations, definitions and functions, and statements without a section of their own.
    Equations,
    /// Events and buttons.
    Events,
    /// Choices.
    Choices,
    /// Tables.
    Tables,
}

impl Section {
    /// All sections, in the order of a form.
    pub const ALL: [Self; 6] =
        [Self::Parameters, Self::InitialValues, Self::Equations, Self::Events, Self::Choices, Self::Tables];
}

/// Section of a statement. The first word of an unreadable statement decides, so that a card keeps its place while its text
/// is edited.
pub(super) fn of(source: &str, statement: &Statement, is_row: bool) -> Section {
    let unread = |left: &model::Expression| left.kind == ExpressionKind::Error;
    match &statement.kind {
        StatementKind::Parameter(_) | StatementKind::Size(_) | StatementKind::Group(_) => Section::Parameters,
        StatementKind::InitialValue { .. } | StatementKind::Discrete { .. } if is_row => Section::InitialValues,
        StatementKind::Choice(_) => Section::Choices,
        StatementKind::Table(_) => Section::Tables,
        StatementKind::Event { .. } => Section::Events,
        StatementKind::Equation { left, right } if unread(left) && unread(right) => {
            let text = &source[statement.span.range()];
            match text.split(|letter: char| !letter.is_alphanumeric()).next().unwrap_or_default() {
                "parameter" | "switch" | "random" | "size" | "group" => Section::Parameters,
                "when" | "every" | "button" | "next" => Section::Events,
                "choice" => Section::Choices,
                "table" | "smooth" | "steps" => Section::Tables,
                _ if is_row => Section::InitialValues,
                _ => Section::Equations,
            }
        }
        _ => Section::Equations,
    }
}
