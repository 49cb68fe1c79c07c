//! What decides how the forms look, apart from what stands in the cells.

use crate::app::App;
use document::form::{CellKind, Part, Section};

/// What the views are built for. While a text is typed it stays, so that what is typed into stays where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Its heading.
    pub section: Section,
    /// The word with which its row begins.
    pub word: String,
    /// What can be edited.
    pub cells: Vec<CellKind>,
    /// Whether it has several lines.
    pub has_lines: bool,
}

/// The shape of a statement.
pub fn shape(part: &Part) -> Shape {
    let cells = part.cells.iter().map(|cell| cell.kind).collect();
    let has_lines = part.section > Section::Equations || part.whole.text.contains('\n');
    Shape { section: part.section, word: part.word.clone(), cells, has_lines }
}

/// What a section is called.
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
