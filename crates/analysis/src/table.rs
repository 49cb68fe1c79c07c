//! Tables of measured data.

use crate::error_name::{self, Belongs};
use crate::origin::Origin;
use crate::run_name;
use std::collections::{BTreeMap, BTreeSet};
use units::Unit;

/// Measured data as columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Columns, in the order of the file.
    pub columns: Vec<Column>,
    /// Relative standard error common to all lengths, such as that of the ruler in a film; `None` if the file does not
    /// state it.
    pub scale_error: Option<f64>,
    /// True if each body is a data set exported with the others: a record of its own.
    pub sets: bool,
    /// Independent variables in each possible reading of the table; empty if there is only one. Until one is chosen,
    /// [`Column::independent`] follows the first.
    pub readings: Vec<Vec<usize>>,
}

/// Column of measured data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Name from the header without the unit; empty without a header.
    pub name: String,
    /// Unit; `None` if the file does not state a known one.
    pub unit: Option<Unit>,
    /// Body (tracked object) or run of the column; `None` if the table has no bodies.
    pub body: Option<String>,
    /// Index of its independent variable; its own index for an independent variable.
    pub independent: usize,
    /// Values in the unit of the column; NaN for an empty cell.
    pub values: Vec<f64>,
    /// Origin of the column in the file.
    pub origin: Origin,
}

impl Column {
    /// Number of cells that hold a number.
    pub fn filled(&self) -> usize {
        self.values.iter().filter(|value| value.is_finite()).count()
    }

    /// Values in SI, for a quantity stated in the unit `quantity` if there is one: a column in rpm is converted to cycles for
    /// a quantity in Hz. A column without a unit is in `quantity`; without both, its values are returned unchanged.
    pub fn si(&self, quantity: Option<&Unit>) -> Vec<f64> {
        match self.unit.as_ref().or(quantity) {
            Some(unit) => {
                let quantity = quantity.unwrap_or(unit);
                self.values.iter().map(|value| unit.to_si_of(*value, quantity)).collect()
            }
            None => self.values.clone(),
        }
    }
}

impl Column {
    /// True if the numbers can be standard errors of the other column: all positive and small compared with its range.
    fn can_be_errors_of(&self, of: &Self) -> bool {
        let finite =
            |values: &[f64]| -> Vec<f64> { values.iter().copied().filter(|value| value.is_finite()).collect() };
        let (errors, values) = (finite(&self.values), finite(&of.values));
        let extreme = |values: &[f64], larger: fn(f64, f64) -> f64| values.iter().copied().reduce(larger);
        let (Some(low), Some(high)) = (extreme(&values, f64::min), extreme(&values, f64::max)) else { return false };
        let (Some(least), Some(most)) = (extreme(&errors, f64::min), extreme(&errors, f64::max)) else { return false };
        least > 0.0 && most < 0.5 * (high - low)
    }
}

impl Table {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// Indices of the independent variables.
    pub fn independent(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.columns.len()).filter(|index| self.is_independent(*index))
    }

    /// Indices of the columns with measured values: not independent variables, and not empty.
    pub fn observed_columns(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.columns.len()).filter(|index| !self.is_independent(*index) && self.columns[*index].filled() > 0)
    }

    fn is_independent(&self, index: usize) -> bool {
        self.columns.get(index).is_some_and(|column| column.independent == index)
    }

    /// Values of the independent variable of a column, in the unit of that variable; empty if there is no such column. NaN
    /// in rows of other bodies.
    pub fn times_of(&self, column: usize) -> &[f64] {
        let times = self.columns.get(column).and_then(|column| self.columns.get(column.independent));
        times.map_or(&[], |times| &times.values)
    }

    /// True if at least two rows with a value of this column have different times.
    pub fn has_times(&self, column: usize) -> bool {
        let Some(own) = self.columns.get(column) else { return false };
        let rows = self.times_of(column).iter().zip(&own.values);
        let mut times = rows.filter(|(time, value)| time.is_finite() && value.is_finite()).map(|(time, _)| *time);
        times.next().is_some_and(|first| times.any(|time| time != first))
    }

    /// Runs of a logger, or data sets, by name with the indices of their columns. Empty unless the table has data sets, or
    /// several runs each with its own clock. Other bodies, such as those of a film, belong together.
    pub fn runs(&self) -> Vec<(String, Vec<usize>)> {
        let mut runs: Vec<(String, Vec<usize>)> = Vec::new();
        for (index, column) in self.columns.iter().enumerate() {
            let Some(name) = column.body.as_ref().filter(|body| self.sets || run_name::name(body).is_some()) else {
                return Vec::new();
            };
            match runs.iter_mut().find(|(run, _)| run == name) {
                Some((_, columns)) => columns.push(index),
                None => runs.push((name.clone(), vec![index])),
            }
        }
        let own_clock = |(_, columns): &(String, Vec<usize>)| columns.iter().any(|index| self.is_independent(*index));
        if self.sets || runs.len() > 1 && runs.iter().all(own_clock) { runs } else { Vec::new() }
    }

    /// Column with the standard errors of another one, of the same body and clock: `sigma_y`, `y_err`, `u(y)`, `±` for `y`.
    /// `dy` and `Δy` count if their numbers can be errors.
    pub fn errors_of(&self, column: usize) -> Option<usize> {
        let own = self.columns.get(column).filter(|own| !own.name.is_empty())?;
        let measured = own.independent != column;
        let belongs = |(index, other): (usize, &Column)| {
            let named = match error_name::of(&other.name) {
                Some(Belongs::To(name)) => name == own.name,
                Some(Belongs::Perhaps(name)) => name == own.name && measured && other.can_be_errors_of(own),
                Some(Belongs::ToPrevious) => {
                    let follows = index == column + 1 && error_name::of(&own.name).is_none();
                    follows && measured && other.can_be_errors_of(own)
                }
                None => false,
            };
            let same = other.body == own.body && other.independent == own.independent;
            let units = own.unit.as_ref().zip(other.unit.as_ref());
            named && index != column && same && units.is_none_or(|(one, other)| one.dimension == other.dimension)
        };
        self.columns.iter().enumerate().position(belongs)
    }

    /// Number of a column, from 1: that in its file, which counts columns of words too.
    pub fn number(&self, index: usize) -> usize {
        self.columns.get(index).map(|column| column.origin.number).filter(|number| *number > 0).unwrap_or(index + 1)
    }

    /// Labels of all columns, as [`Table::label`] gives each.
    pub fn labels(&self) -> Vec<String> {
        let mut names: BTreeMap<&str, usize> = BTreeMap::new();
        let mut groups: BTreeMap<(Option<&str>, &str), Vec<usize>> = BTreeMap::new();
        for (index, column) in self.columns.iter().enumerate() {
            *names.entry(&column.name).or_default() += 1;
            groups.entry((column.body.as_deref(), &column.name)).or_default().push(index);
        }
        let mut labels = vec![String::new(); self.columns.len()];
        for ((_, name), group) in &groups {
            let apart = self.told_apart(group);
            let many = names.get(name).is_some_and(|count| *count > 1);
            for index in group {
                if let Some(label) = labels.get_mut(*index) {
                    // Columns without a name are distinguished by their numbers.
                    *label = if name.is_empty() { self.label(*index) } else { self.labelled(*index, many, apart) };
                }
            }
        }
        labels
    }

    /// Name of a column for users: its name, or its number without one; with its body if that is ambiguous. Columns of one
    /// name in one body are told apart by their units, `t [ms]`, or else by their numbers, `t #3`.
    pub fn label(&self, index: usize) -> String {
        let Some(column) = self.columns.get(index) else { return String::new() };
        let number = self.number(index);
        let same = |other: &usize| {
            self.columns.get(*other).is_some_and(|other| other.name == column.name)
                && (!column.name.is_empty() || self.number(*other) == number)
        };
        let same: Vec<usize> = (0..self.columns.len()).filter(same).collect();
        let beside = |other: &usize| self.columns.get(*other).is_some_and(|other| other.body == column.body);
        let group: Vec<usize> = same.iter().copied().filter(beside).collect();
        self.labelled(index, same.len() > 1, self.told_apart(&group))
    }

    /// Means by which columns of one name in one body are told apart.
    fn told_apart(&self, group: &[usize]) -> Apart {
        let named = group.iter().all(|index| self.columns.get(*index).is_some_and(|column| !column.name.is_empty()));
        let unit = |index: &usize| Some(self.columns.get(*index)?.unit.as_ref()?.text.as_str());
        let units: BTreeSet<&str> = group.iter().filter_map(unit).collect();
        match group {
            [_, _, ..] if named && units.len() == group.len() => Apart::Unit,
            [_, _, ..] if named => Apart::Number,
            _ => Apart::Name,
        }
    }

    /// Name or number of a column, with its body if `many` columns have this name, and with its unit or number.
    fn labelled(&self, index: usize, many: bool, apart: Apart) -> String {
        let Some(column) = self.columns.get(index) else { return String::new() };
        let name = if column.name.is_empty() { self.number(index).to_string() } else { column.name.clone() };
        let name = match (apart, &column.unit) {
            (Apart::Unit, Some(unit)) => format!("{name} [{}]", unit.text),
            (Apart::Number, _) => format!("{name} #{}", self.number(index)),
            _ => name,
        };
        match column.body.as_ref().filter(|_| many) {
            Some(body) => format!("{body}.{name}"),
            None => name,
        }
    }
}

/// Means by which columns of one name in one body are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Apart {
    Name,
    Unit,
    Number,
}
