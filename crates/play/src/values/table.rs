//! The recorded run as a table.

use super::Shown;
use crate::values::symbol::symbol;
use crate::{number, words};
use engine::csv::Dialect;
use engine::table::{Cell, Table};
use program::Node;
use std::ops::Range;
use units::number::Layout;

/// Significant digits of the number with the greatest magnitude in a column.
const DIGITS: usize = 6;

/// Significant digits of numbers that would be rounded to 0 with the decimals of their column.
const SMALL_DIGITS: usize = 3;

/// Format of the cells of a column.
enum ColumnLayout {
    Number(Layout),
    Count,
    /// Hidden by a question.
    Hidden,
}

impl Shown<'_> {
    /// Column headings: `t [s]`, `y [m]`, ...
    pub fn table_header(&self) -> Vec<String> {
        let table = Table::new(self.basis.model());
        let head = |column: &engine::table::Column| {
            let name = symbol(&column.name);
            match column.unit.text.as_str() {
                "" => name,
                unit => format!("{name} [{}]", number::unit_text(unit)),
            }
        };
        table.columns().iter().map(head).collect()
    }

    /// Number of recorded rows.
    pub fn table_length(&self) -> usize {
        self.line.course().rows()
    }

    /// Cells of a range of rows, in the chosen language. Rows beyond the last one are omitted.
    pub fn table_rows(&self, rows: Range<usize>) -> Vec<Vec<String>> {
        let Some(history) = self.line.course().history() else {
            return Vec::new();
        };
        let mut table = Table::new(self.basis.model());
        let layouts = self.column_layouts(&table);
        let rows = rows.start..rows.end.min(self.line.course().rows());
        let text = |(cell, column): (&Cell, &ColumnLayout)| match (cell, column) {
            (_, ColumnLayout::Hidden) => words::hidden(self.basis.language()).to_owned(),
            (Cell::Number(value), ColumnLayout::Number(layout)) => {
                let text = layout.number(*value, self.basis.style());
                // A small number beside the greatest one must not appear as 0.
                let is_lost = *value != 0.0 && !text.contains(|digit: char| ('1'..='9').contains(&digit));
                if is_lost { number::plain(*value, SMALL_DIGITS, self.basis.style()) } else { text }
            }
            _ => self.cell_text(cell),
        };
        rows.map(|row| table.row(history, row).iter().zip(&layouts).map(text).collect()).collect()
    }

    /// Format of each column: equal decimals, chosen for the greatest magnitude of the column in this run; for times,
    /// those of the step.
    fn column_layouts(&self, table: &Table) -> Vec<ColumnLayout> {
        let model = self.basis.model();
        let shown = |quantity: &program::Quantity| quantity.varies && !quantity.remembered;
        let varying = model.quantities.iter().enumerate().filter(|(_, quantity)| shown(quantity));
        let of_author = (0..model.states.len()).filter(|index| model.states[*index].role != program::Role::Remembered);
        let states = of_author.map(|index| (index, model.graph.find(Node::State(index as u32))));
        let others = varying.map(|(index, quantity)| (model.states.len() + index, Some(quantity.value.node)));
        // Events occur between steps, and an adaptive method ends its steps at arbitrary times.
        let off_grid = !model.events.is_empty() || self.line.course().begun().method.adaptive();
        let time = Layout::of_decimals(self.basis.time_decimals(self.line.course()).max(if off_grid { 4 } else { 0 }));
        let scaled = states.chain(others).zip(table.columns().iter().skip(1)).map(|((place, node), column)| {
            let scale = match place.checked_sub(model.states.len()) {
                Some(quantity) => self.values.quantity_scales.get(quantity).copied().unwrap_or_default(),
                None => self.line.greatest(place),
            };
            if place.checked_sub(model.states.len()).is_some_and(|quantity| self.answers.hide(self.basis, quantity)) {
                ColumnLayout::Hidden
            } else if node.is_some_and(|node| self.basis.is_count(node, &column.unit)) {
                ColumnLayout::Count
            } else {
                ColumnLayout::Number(Layout::of_scale(column.unit.from_si(scale), DIGITS))
            }
        });
        std::iter::once(ColumnLayout::Number(time)).chain(scaled).collect()
    }

    /// Index of the last row at or before the time shown.
    pub fn table_row_now(&self) -> usize {
        self.line.course().rows_until_shown().saturating_sub(1)
    }

    /// The whole run as CSV with all digits: byte-identical to the output of the command line, or, for languages with
    /// decimal commas, in the form that spreadsheets of these languages open correctly.
    pub fn csv(&self) -> String {
        let mut out = String::new();
        let mut table = Table::new(self.basis.model());
        let dialect = if self.basis.style().decimal_comma { Dialect::Semicolons } else { Dialect::Lines };
        // Writing to a string cannot fail.
        let _ = table.write_head(dialect, &mut out);
        if let Some(history) = self.line.course().history() {
            for row in 0..self.line.course().rows() {
                let _ = table.write_row(dialect, history, row, &mut out);
            }
        }
        out
    }

    /// The whole run, row by row, with texts in the chosen language.
    pub fn table_cells(&self) -> Vec<Vec<Cell>> {
        let mut table = Table::new(self.basis.model());
        let Some(history) = self.line.course().history() else { return Vec::new() };
        let cell = |cell: &Cell| match cell {
            Cell::Number(value) => Cell::Number(*value),
            other => Cell::Text(self.cell_text(other).into()),
        };
        (0..self.line.course().rows()).map(|row| table.row(history, row).iter().map(cell).collect()).collect()
    }

    fn cell_text(&self, cell: &Cell) -> String {
        match cell {
            Cell::Number(value) => number::plain(*value, DIGITS, self.basis.style()),
            Cell::Truth(value) => words::truth(self.basis.language(), *value).to_owned(),
            Cell::Text(text) => self.basis.text(text).to_owned(),
        }
    }
}
