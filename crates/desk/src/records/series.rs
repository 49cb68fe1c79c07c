//! Columns of a record as series in SI units.

use super::record::{Record, Use};
use program::Independent;
use units::Unit;

impl Record {
    /// Clock reading at which the model begins, SI.
    pub fn origin(&self, independent: &Independent, autonomous: bool) -> f64 {
        self.origin.map_or_else(|| self.beginning(independent, autonomous), |origin| origin.reading)
    }

    /// Default of [`Record::origin()`] before any fit: the first time of all columns in use, or 0 if the equations depend
    /// on time.
    fn beginning(&self, independent: &Independent, autonomous: bool) -> f64 {
        let columns = (0..self.uses.len()).filter(|&column| {
            self.uses.get(column).is_some_and(|used| {
                let quantity = &used.meaning.quantity;
                !quantity.is_empty() && *quantity != independent.name
            })
        });
        let first = |column| {
            let rows = self.rows_as(&self.uses, column, independent)?;
            Some(rows.map(|(time, _)| time).fold(f64::INFINITY, f64::min))
        };
        let first = columns.filter_map(first).fold(f64::INFINITY, f64::min);
        if autonomous && first.is_finite() { first } else { 0.0 }
    }

    /// Times and values of a column, SI, without gaps, ascending in time. Values count turns as the unit of the column does, see
    /// [`units::Unit::turning`]. `None` without usable rows.
    pub fn series(&self, column: usize, independent: &Independent) -> Option<(Vec<f64>, Vec<f64>)> {
        self.series_as(&self.uses, column, independent)
    }

    /// Series of a column as in [`Record::series`], for other uses of the columns.
    pub fn series_as(&self, uses: &[Use], column: usize, independent: &Independent) -> Option<(Vec<f64>, Vec<f64>)> {
        let (times, values): (Vec<f64>, Vec<f64>) = self.rows_as(uses, column, independent)?.unzip();
        // Most records are already sorted, and sorting a million rows is slow.
        if times.is_sorted() {
            return (!times.is_empty()).then_some((times, values));
        }
        let mut rows: Vec<(f64, f64)> = times.into_iter().zip(values).collect();
        rows.sort_by(|one, other| one.0.total_cmp(&other.0));
        Some(rows.into_iter().unzip())
    }

    /// Standard errors of the values of a column from the file, SI, in the order of [`Record::series_as`]; `None`
    /// unless there is a positive one for each value.
    pub fn errors_as(&self, uses: &[Use], column: usize, independent: &str) -> Option<Vec<f64>> {
        let errors = self.errors_beside(uses, column, independent)?;
        errors.iter().all(|error| error.is_finite()).then_some(errors)
    }

    /// Standard errors of the values of a column as in [`Record::errors_as`], NaN if missing or not positive. `None` if
    /// the file has no such column.
    pub fn errors_beside(&self, uses: &[Use], column: usize, independent: &str) -> Option<Vec<f64>> {
        self.errors_in(self.table.errors_of(column)?, uses, column, independent)
    }

    /// Standard errors as in [`Record::errors_beside`], from the column of the index `beside`.
    pub fn errors_in(&self, beside: usize, uses: &[Use], column: usize, independent: &str) -> Option<Vec<f64>> {
        let beside = self.table.columns.get(beside)?;
        let (own, used) = (self.table.columns.get(column)?, uses.get(column)?);
        // A unit stated by the user for the values also holds for their errors.
        let same = beside.unit == own.unit || beside.unit.is_none();
        let unit = if same { &used.meaning.unit } else { beside.unit.as_ref()? };
        let order = self.order_of(uses, column, independent)?;
        let errors = order.into_iter().filter_map(|row| beside.values.get(row));
        let usable = |error: f64| if error > 0.0 && error.is_finite() { error } else { f64::NAN };
        let same = unit.dimension == used.meaning.unit.dimension;
        same.then(|| errors.map(|error| usable(unit.to_si_of(*error, &used.meaning.unit))).collect())
    }

    /// One entry per value of [`Record::series_as`]: true if its row is among `rows`.
    pub fn marks_as<'a>(
        &self,
        uses: &[Use],
        column: usize,
        independent: &str,
        rows: impl IntoIterator<Item = &'a usize>,
    ) -> Option<Vec<bool>> {
        let mut marks = vec![false; self.table.columns.get(column)?.values.len()];
        rows.into_iter().for_each(|row| marks.iter_mut().skip(*row).take(1).for_each(|mark| *mark = true));
        let order = self.order_of(uses, column, independent)?;
        Some(order.into_iter().filter_map(|row| marks.get(row).copied()).collect())
    }

    /// Row in the table of the value at this index of [`Record::series`].
    pub fn row_of(&self, column: usize, independent: &str, place: usize) -> Option<usize> {
        self.order_of(&self.uses, column, independent)?.get(place).copied()
    }

    /// Rows in the table of the values of [`Record::series_as`], in their order.
    fn order_of(&self, uses: &[Use], column: usize, independent: &str) -> Option<Vec<usize>> {
        let own = self.table.columns.get(column)?;
        let times = &self.table.columns.get(self.clock_of(uses, column, independent)?)?.values;
        let rows = times.iter().zip(&own.values).enumerate();
        let rows = rows.filter(|(_, (time, value))| time.is_finite() && value.is_finite());
        let mut rows: Vec<(f64, usize)> = rows.map(|(row, (time, _))| (*time, row)).collect();
        rows.sort_by(|one, other| one.0.total_cmp(&other.0));
        Some(rows.into_iter().map(|(_, row)| row).collect())
    }

    /// Index of the column with the times of a column. One that the user has set as the time has priority over the one that
    /// the file suggests.
    fn clock_of(&self, uses: &[Use], column: usize, independent: &str) -> Option<usize> {
        let own = self.table.columns.get(column)?;
        let is_time = |index: &usize| uses.get(*index).is_some_and(|used| used.meaning.quantity == independent);
        Some(own.independent).filter(is_time).or_else(|| (0..uses.len()).find(is_time))
    }

    /// Time and value, SI, of each row that has both.
    fn rows_as(
        &self,
        uses: &[Use],
        column: usize,
        independent: &Independent,
    ) -> Option<impl Iterator<Item = (f64, f64)> + use<'_>> {
        let own = self.table.columns.get(column)?;
        let value_unit = uses.get(column)?.meaning.unit.clone();
        let clock = self.clock_of(uses, column, &independent.name)?;
        if self.asks_for_unit(uses, column) || self.asks_for_unit(uses, clock) {
            return None;
        }
        let (times, time_unit) = (&self.table.columns.get(clock)?.values, uses.get(clock)?.meaning.unit.clone());
        let rows = times.iter().zip(&own.values).filter(|(time, value)| time.is_finite() && value.is_finite());
        // A time column with a single repeated value is not usable.
        let mut others = rows.clone().map(|(time, _)| *time);
        let first = others.next()?;
        if others.next().is_some() && times.iter().all(|time| time.is_nan() || *time == first) {
            return None;
        }
        let own_unit = independent.unit.clone();
        Some(rows.map(move |(time, value)| (time_unit.to_si_of(*time, &own_unit), value_unit.to_si(*value))))
    }
}

/// Converts SI values of a column in the unit `own` for a quantity stated in the unit `quantity`, if one unit counts cycles and
/// the other angles.
pub(crate) fn turn(values: &mut [f64], own: &Unit, quantity: &Unit) {
    let factor = own.turning(quantity);
    if factor != 1.0 {
        values.iter_mut().for_each(|value| *value *= factor);
    }
}
