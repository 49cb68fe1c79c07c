//! Sections: points of the run at multiples of a period (the Poincaré section of a driven motion) or at each firing of
//! an event.

use super::traces::PlotColumns;
use crate::time::course::Course;
use engine::Readings;
use program::{Every, Model, NodeId, Plot};
use units::Unit;

/// Maximum number of points of a section: more are not visible, and a tiny period would give arbitrarily many.
const MOST: usize = 50_000;

/// Times of the points.
#[derive(Debug)]
pub(crate) enum Moments {
    /// Multiples of a period.
    Every(Every),
    /// Times at which this count rises. The point shows the state before the event.
    Firings(NodeId),
}

/// Points of one plot.
#[derive(Debug)]
pub(crate) struct Section {
    moments: Moments,
    /// The period or the count of firings, then abscissa and ordinate of each curve.
    readings: Readings,
    /// Units of the values after the first one.
    units: Vec<Unit>,
    /// Number of rows of the run processed so far.
    rows: usize,
    /// For each point, the index of the row that follows it.
    places: Vec<usize>,
    /// Abscissas and ordinates of each curve: two columns per curve, one value per point.
    columns: Vec<Vec<f64>>,
    state: Vec<f64>,
}

impl Section {
    /// Section for a plot with these columns.
    pub fn new(model: &Model, plot: &Plot, moments: Moments, columns: &PlotColumns) -> Self {
        let mut nodes = match &moments {
            Moments::Every(every) => vec![every.period],
            Moments::Firings(count) => vec![*count],
        };
        let mut units = Vec::new();
        for (number, (curve, place)) in plot.curves.iter().zip(&columns.curves).enumerate() {
            nodes.extend([plot.x_of(number).value.node, curve.value.node]);
            let axis = columns.axes.get(place.axis).unwrap_or(&curve.value.unit);
            units.extend([plot.x.value.unit.clone(), axis.clone()]);
        }
        Self {
            moments,
            readings: Readings::new(model, &nodes),
            columns: vec![Vec::new(); units.len()],
            units,
            rows: 0,
            places: Vec::new(),
            state: vec![0.0; model.states.len()],
        }
    }

    /// Abscissas and ordinates of a curve, in the units of the plot.
    pub fn curve(&self, number: usize) -> (&[f64], &[f64]) {
        let column = |place: usize| self.columns.get(place).map_or(&[][..], Vec::as_slice);
        (column(2 * number), column(2 * number + 1))
    }

    /// Discards the points in rows with index `rows` or higher.
    pub fn truncate(&mut self, rows: usize) {
        self.rows = self.rows.min(rows);
        let kept = self.places.partition_point(|place| *place < rows);
        self.places.truncate(kept);
        self.columns.iter_mut().for_each(|column| column.truncate(kept));
    }

    /// Adds the points up to the front of the run.
    pub fn follow(&mut self, course: &mut Course) {
        let rows = course.rows();
        self.truncate(rows);
        for row in self.rows.max(1)..rows {
            if self.places.len() >= MOST {
                break;
            }
            match self.moments {
                Moments::Every(_) => self.multiples(course, row),
                Moments::Firings(_) => self.firing(course, row),
            }
        }
        self.rows = rows;
    }

    /// Adds the state before an event that fired between the previous row and this one.
    fn firing(&mut self, course: &Course, row: usize) {
        let Some(history) = course.history() else { return };
        let mut count = |row: usize| self.readings.at_row(history, row).first().copied().unwrap_or(0.0);
        let (after, before) = (count(row), count(row - 1));
        if after > before {
            let values = self.readings.at_row(history, row - 1);
            for ((column, value), unit) in self.columns.iter_mut().zip(values.iter().skip(1)).zip(&self.units) {
                column.push(unit.from_si(*value));
            }
            self.places.push(row);
        }
    }

    /// Adds the points at multiples of the period between the previous row and this one.
    fn multiples(&mut self, course: &mut Course, row: usize) {
        let (Moments::Every(every), Some(history)) = (&self.moments, course.history()) else { return };
        let (start, end) = (history.time(row - 1), history.time(row));
        let parameters = history.parameters(row).to_vec();
        let initial = history.initial().to_vec();
        let period = self.readings.at(&parameters, &initial, 0.0, &initial).first().copied().unwrap_or(f64::NAN);
        if !(period > 0.0 && period.is_finite()) {
            return;
        }
        // Products instead of sums, so that the times do not drift against the drive.
        let first = every.from.unwrap_or(period);
        let mut number = ((start - first) / period).floor().max(0.0);
        while self.places.len() < MOST {
            let time = first + number * period;
            if time > end {
                break;
            }
            let at_start = row == 1 && time == start;
            if time > start || at_start {
                course.interpolate(time, &mut self.state);
                let values = self.readings.at(&parameters, &initial, time, &self.state);
                for ((column, value), unit) in self.columns.iter_mut().zip(values.iter().skip(1)).zip(&self.units) {
                    column.push(unit.from_si(*value));
                }
                self.places.push(row);
            }
            number += 1.0;
        }
    }
}
