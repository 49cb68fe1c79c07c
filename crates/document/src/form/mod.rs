//! Form view of the model: rows of cells for parameters and initial values, and the text of every other statement, each
//! with its place. [`crate::edit`] changes a cell by its place.
//!
//! Cells are nodes of the syntax tree, so they exist while one holds something wrong. [`plots()`] and [`shown()`] give the
//! same for plots, controls with their groups, and values.

mod cells;
mod plots;
mod proposal;
mod section;
mod shown;

pub use cells::{Cell, CellKind};
pub(crate) use plots::sentences as plot_sentences;
pub use plots::{PlotCell, PlotPart, plots};
pub use proposal::proposal;
pub use section::Section;
pub use shown::{Place, Shown, plottable, shown};

use crate::text::source::trim;
use crate::{BlockKind, Outline};
use model::Span;

/// Form of the model of a document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Form {
    /// One part per statement, in text order.
    pub parts: Vec<Part>,
}

/// A statement in a form.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Section in which it is shown.
    pub section: Section,
    /// Index of its block in [`Outline::blocks`].
    pub block: usize,
    /// Place without the comment.
    pub span: Span,
    /// Keyword of a row: `parameter`, `switch`, `random`, `size`, `group`, `discrete`; otherwise empty.
    pub word: String,
    /// The whole text as one cell.
    pub whole: Cell,
    /// Editable cells: the cells of a row in the order of [`CellKind`], or one cell with the whole text.
    pub cells: Vec<Cell>,
    /// The statement as `<math>` elements; empty if there is nothing to typeset.
    pub typeset: String,
}

/// Form of a document. Every statement has a part, even with errors.
pub fn read(outline: &Outline) -> Form {
    let mut parts = structure(outline);
    let typeset = model::typeset_each(&statements(outline), &str::to_owned);
    for (part, typeset) in parts.iter_mut().zip(typeset) {
        part.typeset = typeset.concat();
    }
    Form { parts }
}

/// Form without typeset equations, to find places.
pub fn places(outline: &Outline) -> Form {
    Form { parts: structure(outline) }
}

/// Statements of the parts, in the same order.
pub(crate) fn statements(outline: &Outline) -> Vec<model::Statement> {
    outline.blocks().iter().flat_map(|block| &block.statements).cloned().collect()
}

/// Parts without typeset equations.
pub(crate) fn structure(outline: &Outline) -> Vec<Part> {
    let source = outline.source();
    let blocks = outline.blocks().iter().enumerate();
    let statements = blocks.flat_map(|(number, block)| block.statements.iter().map(move |one| (number, block, one)));
    let part = |(number, block, statement): (usize, &crate::Block, &model::Statement)| {
        let row = (block.kind == BlockKind::Model).then(|| cells::row(source, statement)).flatten();
        let section = section::of(source, statement, row.is_some());
        let written = trim(source, statement.span.range());
        let span = Span::new(written.start, written.end);
        let whole = Cell::whole(source, span);
        let (word, cells) = row.unwrap_or_else(|| (String::new(), vec![whole.clone()]));
        Part { section, block: number, span, word, whole, cells, typeset: String::new() }
    };
    statements.map(part).collect()
}

impl Part {
    /// The cell of a kind. [`CellKind::Text`] is the whole text, also of a row.
    pub fn cell(&self, kind: CellKind) -> Option<&Cell> {
        if kind == CellKind::Text { Some(&self.whole) } else { self.cells.iter().find(|cell| cell.kind == kind) }
    }
}

impl Form {
    /// Index of the part and kind of the cell at a byte; outside all cells, the first cell of the part.
    pub fn at(&self, place: usize) -> Option<(usize, CellKind)> {
        let number = self.parts.iter().position(|part| part.span.start <= place && place <= part.span.end)?;
        let part = self.parts.get(number)?;
        let holds = |cell: &&Cell| cell.outer.start <= place && place < cell.outer.end.max(cell.outer.start + 1);
        let cell = part.cells.iter().find(holds).or_else(|| part.cells.first())?;
        Some((number, cell.kind))
    }
}
