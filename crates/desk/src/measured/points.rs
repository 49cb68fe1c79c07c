//! Measured values beside the model: the columns in use as points over the curves.

use crate::Desk;
use crate::measured::data::{Measured, Residuals};
use crate::records::recognise::observed;
use crate::records::record::{Record, Use};
use engine::Readings;
use play::{Points, points_colour, symbol};
use program::{Curve, Drawing};

/// Maximum length of a record's name in a legend, in characters.
const LONGEST_NAME: usize = 24;

impl Desk {
    /// True if a measured quantity is drawn.
    pub fn has_points(&self) -> bool {
        !self.data.measured.is_empty()
    }

    /// Recomputes everything that depends on the records. Must be called whenever records or the meanings of their
    /// columns have changed.
    pub(crate) fn records_changed(&mut self) {
        let model = self.play.model();
        let independent = &model.independent.name;
        let autonomous = model.is_autonomous();
        self.data.records.iter_mut().for_each(|record| record.settle_made(&self.document));
        let mut measured = Vec::new();
        for record in self.data.records.iter().filter(|record| record.shown) {
            let origin = record.origin(independent, autonomous);
            for (index, used) in record.uses.iter().enumerate() {
                let name = &used.meaning.quantity;
                if name.is_empty() || name == independent {
                    continue;
                }
                let Some(observed) = observed(model, name) else { continue };
                if observed.dimension() == used.meaning.unit.dimension
                    && let Some((mut times, mut values)) = record.series(index, independent)
                {
                    times.iter_mut().for_each(|time| *time -= origin);
                    values.iter_mut().for_each(|value| *value -= used.offset);
                    let pause = usual_pause(&times);
                    let errors = record.errors_beside(&record.uses, index, independent).unwrap_or_default();
                    let (record, name) = (record.id, name.clone());
                    measured.push(Measured { record, name, observed, times, values, errors, pause });
                }
            }
        }
        let mut drawn = Vec::new();
        for plot in &self.document.program.plots {
            let name = |id: u32| self.record(id).map_or("", |record| record.name.as_str());
            drawn.push(points(model, plot, &measured, &name));
        }
        self.data.residuals = measured
            .iter()
            .map(|measured| Residuals { readings: Readings::new(model, &[measured.observed.node]), passed: 0 })
            .collect();
        self.data.measured = measured;
        self.data.version += 1;
        for (plot, mut points) in drawn.into_iter().enumerate() {
            for (number, points) in points.iter_mut().enumerate() {
                points.version = self.data.version_of(number);
            }
            self.play.change_plots(|plots| plots.set_points(plot, points));
        }
        self.begin_outline();
        self.begin_residuals();
        self.find_cycles();
        self.revision.records += 1;
    }
}

impl Record {
    /// Clock reading at which the model begins, SI.
    pub fn origin(&self, independent: &str, autonomous: bool) -> f64 {
        self.origin.map_or_else(|| self.beginning(independent, autonomous), |origin| origin.reading)
    }

    /// Default of [`Record::origin()`] before any fit: the first time of all columns in use, or 0 if the equations depend
    /// on time.
    fn beginning(&self, independent: &str, autonomous: bool) -> f64 {
        let columns = (0..self.uses.len()).filter(|&column| {
            self.uses.get(column).is_some_and(|used| {
                let quantity = &used.meaning.quantity;
                !quantity.is_empty() && quantity != independent
            })
        });
        let first = |column| {
            let rows = self.rows_as(&self.uses, column, independent)?;
            Some(rows.map(|(time, _)| time).fold(f64::INFINITY, f64::min))
        };
        let first = columns.filter_map(first).fold(f64::INFINITY, f64::min);
        if autonomous && first.is_finite() { first } else { 0.0 }
    }

    /// Times and values of a column, SI, without gaps, ascending in time. `None` without usable rows.
    pub fn series(&self, column: usize, independent: &str) -> Option<(Vec<f64>, Vec<f64>)> {
        self.series_as(&self.uses, column, independent)
    }

    /// Series of a column as in [`Record::series`], for other uses of the columns.
    pub fn series_as(&self, uses: &[Use], column: usize, independent: &str) -> Option<(Vec<f64>, Vec<f64>)> {
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
        let is_time = |index: &usize| uses.get(*index).is_some_and(|used| used.meaning.quantity == independent);
        let clock = Some(own.independent).filter(is_time).or_else(|| (0..uses.len()).find(is_time))?;
        let times = &self.table.columns.get(clock)?.values;
        let rows = times.iter().zip(&own.values).zip(&beside.values);
        let rows = rows.filter(|((time, value), _)| time.is_finite() && value.is_finite());
        let mut rows: Vec<(f64, f64)> = rows.map(|((time, _), error)| (*time, unit.to_si(*error))).collect();
        rows.sort_by(|one, other| one.0.total_cmp(&other.0));
        let usable = |error: f64| if error > 0.0 && error.is_finite() { error } else { f64::NAN };
        let same = unit.dimension == used.meaning.unit.dimension;
        same.then(|| rows.into_iter().map(|(_, error)| usable(error)).collect())
    }

    /// Time and value, SI, of each row that has both.
    fn rows_as(
        &self,
        uses: &[Use],
        column: usize,
        independent: &str,
    ) -> Option<impl Iterator<Item = (f64, f64)> + use<'_>> {
        let own = self.table.columns.get(column)?;
        let value_unit = uses.get(column)?.meaning.unit.clone();
        // A column that the user has set as the time has priority over the one that the file suggests.
        let is_time = |index: &usize| uses.get(*index).is_some_and(|used| used.meaning.quantity == independent);
        let clock = Some(own.independent).filter(is_time).or_else(|| (0..uses.len()).find(is_time))?;
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
        Some(rows.map(move |(time, value)| (time_unit.to_si(*time), value_unit.to_si(*value))))
    }
}

/// Measured points of a plot.
fn points<'a>(
    model: &program::Model,
    plot: &program::Plot,
    measured: &[Measured],
    record_name: &dyn Fn(u32) -> &'a str,
) -> Vec<Points> {
    let mut found = Vec::new();
    if plot.drawing != Drawing::Run {
        return found;
    }
    let of = |curve: &Curve, measured: &&Measured| measured.observed.node == curve.value.node;
    // Curves of the same dimension share an axis and the unit of the first of them.
    let unit = |curve: &Curve| {
        let same = |other: &&Curve| other.value.dimension() == curve.value.dimension();
        plot.curves.iter().find(same).map_or_else(|| curve.value.unit.clone(), |first| first.value.unit.clone())
    };
    for (number, curve) in plot.curves.iter().enumerate() {
        let (unit, across) = (unit(curve), plot.x_of(number));
        let against_time = model.is_independent(across.value.node);
        for (place, column) in measured.iter().enumerate().filter(|(_, measured)| of(curve, measured)) {
            let (x_unit, y_unit) = (&plot.x.value.unit, &unit);
            let error = |error: &f64| y_unit.from_si(*error);
            let (x, y, errors): (Vec<f64>, Vec<f64>, Vec<f64>) = if against_time {
                let x = column.times.iter().map(|time| x_unit.from_si(*time)).collect();
                let y = column.values.iter().map(|value| y_unit.from_si(*value)).collect();
                (x, y, column.errors.iter().map(error).collect())
            } else {
                let Some(other) = measured.iter().find(|other| other.record == column.record && of(across, other))
                else {
                    continue;
                };
                let at = |(number, (time, value)): (usize, (&f64, &f64))| {
                    let row = other.times.partition_point(|at| at < time);
                    let other = (other.times.get(row) == Some(time)).then(|| other.values.get(row)).flatten()?;
                    let error = column.errors.get(number).map_or(f64::NAN, error);
                    Some((x_unit.from_si(*other), y_unit.from_si(*value), error))
                };
                let (mut x, mut y, mut errors) = (Vec::new(), Vec::new(), Vec::new());
                for (across, up, error) in column.times.iter().zip(&column.values).enumerate().filter_map(at) {
                    x.push(across);
                    y.push(up);
                    errors.push(error);
                }
                (x, y, errors)
            };
            let label = format!("{} ({})", symbol(&curve.expression), shortened(record_name(column.record)));
            let source = record_name(column.record).to_owned();
            let colour = points_colour(place);
            found.push(Points { curve: number, colour, label, source, x, y, errors, version: 0 });
        }
    }
    found
}

/// Name of a record, shortened for a legend.
pub(crate) fn shortened(name: &str) -> String {
    if name.chars().count() <= LONGEST_NAME {
        return name.to_owned();
    }
    let start: String = name.chars().take(LONGEST_NAME - 1).collect();
    format!("{}…", start.trim_end())
}

/// Longest interval between two times that is not a gap: three times the median interval. For long records the median
/// is taken of a sample.
fn usual_pause(times: &[f64]) -> f64 {
    const ENOUGH: usize = 10_000;
    let pairs = times.windows(2).step_by(1 + times.len() / ENOUGH);
    let pauses: Vec<f64> = pairs.map(|pair| pair[1] - pair[0]).filter(|pause| *pause > 0.0).collect();
    if pauses.is_empty() {
        return f64::INFINITY;
    }
    3.0 * units::order::median(pauses)
}
