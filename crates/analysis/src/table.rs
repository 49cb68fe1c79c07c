//! Measured data as columns.

use units::Unit;

/// Measured data: columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns, in the order of the file.
    pub columns: Vec<Column>,
}

/// One column of measured data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// The name from the header, ASCII or not, without the unit; empty without a header.
    pub name: String,
    /// The unit from the header, if it gives one.
    pub unit: Option<Unit>,
    /// The body (the tracked object) it belongs to, where the file has several.
    pub body: Option<String>,
    /// The column of the independent variable it belongs to; its own number for such a column itself.
    pub independent: usize,
    /// The values in the column's unit; NaN where the cell is empty.
    pub values: Vec<f64>,
}

impl Table {
    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }
}
