//! The model of a document as forms show it: rows of cells for parameters and initial values, and the text of every other
//! statement, each with its place. [`crate::edit`] changes a cell by its place.

mod cells;
mod plots;
mod proposal;
mod section;
mod shown;

pub use cells::{Cell, CellKind};
pub use plots::{PlotCell, PlotPart, plots};
pub use proposal::proposal;
pub use section::Section;
pub use shown::{Place, Shown, plottable, shown};

use crate::text::source::trim;
use crate::{BlockKind, Outline};
use model::Span;

/// What the statements of a model are in a form.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Form {
    /// One part for each statement, in the order of the text.
    pub parts: Vec<Part>,
}

/// A statement in a form.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Under which heading it stands.
    pub section: Section,
    /// The index of its block in [`Outline::blocks`].
    pub block: usize,
    /// Where it stands, without its comment.
    pub span: Span,
    /// The word with which a row begins: `parameter`, `switch`, `random`, `size`, `group`, `discrete`; otherwise empty.
    pub word: String,
    /// The whole text.
    pub whole: Cell,
    /// What can be edited: the cells of a row in the order of [`CellKind`], or one cell with the whole text.
    pub cells: Vec<Cell>,
    /// The statement as `<math>` elements; empty where there is nothing to typeset.
    pub typeset: String,
}

/// Reads the form of a document. Every statement has a part, also one that has errors.
pub fn read(outline: &Outline) -> Form {
    let mut parts = structure(outline);
    let typeset = model::typeset_each(&statements(outline), &str::to_owned);
    for (part, typeset) in parts.iter_mut().zip(typeset) {
        part.typeset = typeset.concat();
    }
    Form { parts }
}

/// The same without typeset equations, for who looks for a place.
pub fn places(outline: &Outline) -> Form {
    Form { parts: structure(outline) }
}

/// The statements that the parts show.
pub(crate) fn statements(outline: &Outline) -> Vec<model::Statement> {
    outline.blocks().iter().flat_map(|block| &block.statements).cloned().collect()
}

/// The parts without typeset equations.
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
    /// The cell of a kind. A row has its whole text beside its cells.
    pub fn cell(&self, kind: CellKind) -> Option<&Cell> {
        if kind == CellKind::Text { Some(&self.whole) } else { self.cells.iter().find(|cell| cell.kind == kind) }
    }
}

impl Form {
    /// The part and the cell at a place, in bytes: the cell that holds it, or else the first one.
    pub fn at(&self, place: usize) -> Option<(usize, CellKind)> {
        let number = self.parts.iter().position(|part| part.span.start <= place && place <= part.span.end)?;
        let part = self.parts.get(number)?;
        let holds = |cell: &&Cell| cell.outer.start <= place && place < cell.outer.end.max(cell.outer.start + 1);
        let cell = part.cells.iter().find(holds).or_else(|| part.cells.first())?;
        Some((number, cell.kind))
    }
}
