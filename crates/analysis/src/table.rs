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
    /// The body (the tracked object) it belongs to, where the file names bodies or has several, each with its own time.
    pub body: Option<String>,
    /// The column of the independent variable it belongs to; its own number for such a column itself.
    pub independent: usize,
    /// The values in the column's unit; NaN where the cell is empty.
    pub values: Vec<f64>,
}

impl Column {
    /// How many cells hold a number.
    pub fn filled(&self) -> usize {
        self.values.iter().filter(|value| value.is_finite()).count()
    }

    /// The values in SI. A column without a unit of its own is in `fallback`; without either its values stand as they
    /// are.
    pub fn si(&self, fallback: Option<&Unit>) -> Vec<f64> {
        match self.unit.as_ref().or(fallback) {
            Some(unit) => self.values.iter().map(|value| unit.to_si(*value)).collect(),
            None => self.values.clone(),
        }
    }
}

impl Table {
    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The column that is called `which`: by its name (`y`), the body's and its name (`mass_A.y`), else by its number,
    /// from 1. Where several have the name it is the first of them; capitals matter only if there is a choice.
    pub fn column(&self, which: &str) -> Option<usize> {
        let which = which.trim();
        let named = |same: &dyn Fn(&str, &str) -> bool| {
            self.columns.iter().position(|column| {
                same(&column.name, which)
                    || column.body.as_deref().is_some_and(|body| is_in_body(which, body, &column.name, same))
            })
        };
        if which.is_empty() {
            return None;
        }
        named(&|name, wanted| name == wanted)
            .or_else(|| named(&|name, wanted| name.eq_ignore_ascii_case(wanted)))
            .or_else(|| which.parse().ok().and_then(|number: usize| number.checked_sub(1)))
            .filter(|index| *index < self.columns.len())
    }

    /// The columns of independent variables.
    pub fn independent(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.columns.len()).filter(|index| self.is_independent(*index))
    }

    /// The columns that hold something measured: no independent variable, and not empty.
    pub fn observed_columns(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.columns.len()).filter(|index| !self.is_independent(*index) && self.columns[*index].filled() > 0)
    }

    fn is_independent(&self, index: usize) -> bool {
        self.columns.get(index).is_some_and(|column| column.independent == index)
    }

    /// The independent variable of a column, in the unit of its own column; empty if there is no such column. Rows in
    /// which it is NaN belong to other bodies.
    pub fn times_of(&self, column: usize) -> &[f64] {
        let times = self.columns.get(column).and_then(|column| self.columns.get(column.independent));
        times.map_or(&[], |times| &times.values)
    }

    /// What a column is called for a person: its name; `body.name` where that is not enough; its number without a name.
    pub fn label(&self, index: usize) -> String {
        let Some(column) = self.columns.get(index) else { return String::new() };
        let same = |other: &&Column| other.name == column.name;
        match &column.body {
            _ if column.name.is_empty() => (index + 1).to_string(),
            Some(body) if self.columns.iter().filter(same).count() > 1 => format!("{body}.{}", column.name),
            _ => column.name.clone(),
        }
    }
}

/// Whether `which` is `body.name`.
fn is_in_body(which: &str, body: &str, name: &str, same: &dyn Fn(&str, &str) -> bool) -> bool {
    let (Some(first), Some(rest)) = (which.get(..body.len()), which.get(body.len()..)) else { return false };
    same(first, body) && rest.strip_prefix('.').is_some_and(|rest| same(name, rest))
}
