//! Structure of the forms, without the contents of their cells.

use crate::app::App;
use document::form::{CellKind, Part, Section};

/// Structure of the views of a statement. It is kept while a text is being typed, so that the field stays in place.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Section of the statement.
    pub section: Section,
    /// Keyword at the start of its row.
    pub word: String,
    /// Editable cells.
    pub cells: Vec<CellKind>,
    /// True if it has several lines.
    pub has_lines: bool,
}

/// Structure of a statement.
pub fn shape(part: &Part) -> Shape {
    let cells = part.cells.iter().map(|cell| cell.kind).collect();
    let has_lines = part.section > Section::Equations || part.whole.text.contains('\n');
    Shape { section: part.section, word: part.word.clone(), cells, has_lines }
}

/// Title of a section.
pub fn title(app: App, section: Section) -> &'static str {
    let words = app.words();
    match section {
        Section::Parameters => words.form_parameters,
        Section::InitialValues => words.form_initial_values,
        Section::Equations => words.form_equations,
        Section::Events => words.form_events,
        Section::Choices => words.form_choices,
        Section::Tables => words.form_tables,
    }
}
